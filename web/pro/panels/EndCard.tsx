// How a run ended: the port of the root, how long it took, the chain of ports that led there, what came from outside, and the results.
import { useMemo } from "react";
import type { Core } from "../../generated/messages";
import { counted } from "../../shared/counted";
import { causes } from "../../shared/run/causes";
import { isOver, statusLook, statusText } from "../../shared/run/controls";
import { inputText } from "../../shared/run/inputText";
import { leasedText } from "../../shared/stop/leases";
import type { ModelTree } from "../../shared/model/modelTree";
import { useCore, useSession } from "../client";
import { MakeTest } from "../runs/MakeTest";
import { CauseList } from "./CauseList";
import { CodeText } from "./CodeText";
import { showInput } from "./showInput";
import { useDuration } from "./useDuration";
import { ValueTable } from "./ValueTable";

export function EndCard({ tree }: { readonly tree: ModelTree | undefined }) {
  const core = useCore();
  const steps = useSession((s) => s.steps);
  const root = tree?.keys().next().value;
  const address = core?.outcome === undefined || root === undefined ? undefined : `${root}.${core.outcome}`;
  const chain = useMemo(() => (tree === undefined || address === undefined ? [] : causes(tree, steps, address)), [tree, steps, address]);
  const over = core !== undefined && isOver(core) ? core : undefined;
  const duration = useDuration(over?.step === 0 ? undefined : over?.id);
  const leased = useMemo(() => (over !== undefined && (over.fault !== undefined || statusLook(over) === "failed") ? leasedText(steps) : undefined), [over, steps]);
  if (over === undefined) return null;
  const last = chain.at(-1);
  return (
    <section className="end-card" aria-label="How it ended">
      <h3>
        {over.outcome === undefined ? (
          endText(over)
        ) : (
          <>
            Left through <code>{over.outcome}</code>
          </>
        )}
      </h3>
      {duration !== undefined && (
        <p>
          Took <b>{duration}</b>, {counted(over.step, "macro step")}
        </p>
      )}
      {leased !== undefined && (
        <p>
          <CodeText text={leased} />
        </p>
      )}
      <CauseList chain={chain} />
      {last?.input !== undefined && (
        <p>
          Upon{" "}
          <button type="button" className="link" onClick={() => showInput(last.firing.step)}>
            <code>{inputText(last.input)}</code>
          </button>
        </p>
      )}
      {over.results !== undefined && <ValueTable title="Results" names={Object.keys(over.results)} values={over.results} />}
      <MakeTest key={over.id} id={over.id} document={over.document} />
    </section>
  );
}

/** Of a run that did not end through a port; what the fault was stands below. */
const endText = (core: Core): string => (core.status === "faulted" ? "Ended by a fault" : statusText(core));
