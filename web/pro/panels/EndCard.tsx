// How a run ended: the port of the root, the chain of ports that led there, what came from outside, and the results.
import { useMemo } from "react";
import { causes, type Cause } from "../../shared/run/causes";
import { inputText } from "../../shared/run/inputText";
import type { ModelTree } from "../../shared/model/modelTree";
import { useCore, useSession, view } from "../client";
import { ValueTable } from "./ValueTable";

export function EndCard({ tree }: { readonly tree: ModelTree | undefined }) {
  const core = useCore();
  const steps = useSession((s) => s.steps);
  const root = tree?.keys().next().value;
  const address = core?.outcome === undefined || root === undefined ? undefined : `${root}.${core.outcome}`;
  const chain = useMemo(() => (tree === undefined || address === undefined ? [] : causes(tree, steps, address)), [tree, steps, address]);
  if (core?.outcome === undefined) return null;
  const last = chain.at(-1);
  return (
    <section className="end-card" aria-label="How it ended">
      <h3>
        Left through <code>{core.outcome}</code>
      </h3>
      <ol aria-label="Causes">
        {chain.map((cause) => (
          <li key={cause.address}>
            <CauseRow cause={cause} />
          </li>
        ))}
      </ol>
      {last?.input !== undefined && (
        <p>
          Upon <code>{inputText(last.input)}</code>
        </p>
      )}
      {core.results !== undefined && <ValueTable title="Results" names={Object.keys(core.results)} values={core.results} />}
    </section>
  );
}

function CauseRow({ cause: { address, condition, firing } }: { readonly cause: Cause }) {
  return (
    <>
      <button type="button" className="link" onClick={() => view.dispatch({ type: "jump", selection: { kind: "port", address } })}>
        {address}
      </button>
      <code>{condition}</code>
      <button type="button" className="link" onClick={() => view.dispatch({ type: "step", step: firing.step })}>
        macro step {firing.step}, micro step {firing.micro}
      </button>
    </>
  );
}
