// Properties when nothing is selected: the run as a whole.
import type { ModelTree } from "../../shared/model/modelTree";
import { goesOnMeanwhile, isOver, kEffects, statusLook, statusText } from "../../shared/run/controls";
import { inputText } from "../../shared/run/inputText";
import { movedBy } from "../../shared/run/moving";
import { lastStatusText } from "../../shared/run/lostText";
import { follow, useCore, useSession } from "../client";
import { PastProperties } from "../past/PastProperties";
import { useRefusal } from "../login/rights";
import { CodeText } from "./CodeText";
import { EndCard } from "./EndCard";
import { FaultCard } from "./FaultCard";
import { HeldInputs } from "./HeldInputs";
import { Leases } from "./Leases";
import { OpenCalls } from "./OpenCalls";
import { usePersonStatus } from "./question";
import { ValueTable } from "./ValueTable";

export function RunProperties({ tree }: { readonly tree: ModelTree | undefined }) {
  const core = useCore();
  const last = useSession((s) => s.lastInput);
  const past = useSession((s) => s.past?.past);
  const name = useSession((s) => s.model?.name);
  const refusal = useRefusal("follow_edits");
  const lost = useSession((s) => s.connection === "lost");
  const asks = usePersonStatus();
  const stops = useSession((s) => core?.status === "running" && s.model !== undefined && movedBy(s.model, s.services)?.length !== 0);
  if (core === undefined) {
    return (
      <div className="empty-note">
        <h2>Nothing is running</h2>
        <p>Load a document to make a run of it, then start it with F5.</p>
      </div>
    );
  }
  if (past !== undefined) return <PastProperties core={core} past={past} />;
  const { fault, interruption } = core;
  const meanwhile = goesOnMeanwhile(core);
  return (
    <>
      <header className="prop-head">
        <small>Run {core.id}</small>
        <h2>{name === undefined || name === "" ? core.document : name}</h2>
        <span className={`pill is-${asks !== undefined ? "paused" : statusLook(core)}`}>{lost ? lastStatusText(core) : asks !== undefined && !core.paused ? asks : statusText(core)}</span>
      </header>
      {meanwhile !== undefined && !lost && <p className="quiet">{meanwhile}.</p>}
      {stops && !lost && <p className="quiet">Stop: {kEffects.stop}.</p>}
      {!lost && <Leases own={core.id} />}
      {interruption !== undefined && (
        <section className="interrupted" aria-label="Interrupted">
          <h3>Interrupted</h3>
          <p>
            <CodeText text={interruption.message} />
          </p>
        </section>
      )}
      <EndCard tree={tree} />
      {fault !== undefined && <FaultCard core={core} fault={fault} tree={tree} />}
      <section>
        <h3>Progress</h3>
        <dl className="pairs">
          <dt>Macro step</dt>
          <dd>{core.step}</dd>
          <dt>Inputs waiting</dt>
          <dd>{core.waiting}</dd>
          {last !== undefined && (
            <>
              <dt>Last input</dt>
              <dd>
                <code>{inputText(last)}</code>
              </dd>
            </>
          )}
        </dl>
      </section>
      <HeldInputs core={core} />
      <OpenCalls core={core} />
      {!isOver(core) && (
        <section>
          <h3>Document</h3>
          <p className="quiet">
            {core.document}, revision {core.revision}
          </p>
          <label className="follow" title={refusal}>
            <input type="checkbox" checked={core.live} disabled={lost || refusal !== undefined} onChange={(event) => void follow(event.target.checked)} /> Follow edits while it runs
          </label>
          <p className="quiet">Each edit without errors then changes this run between its macro steps. A new port or action may move the robot.</p>
        </section>
      )}
      <ValueTable title="Arguments" values={core.arguments} names={Object.keys(core.arguments)} />
      <p className="quiet">Select a state, a barrier or a port to see its values.</p>
    </>
  );
}
