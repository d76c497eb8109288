// Properties when nothing is selected: the run as a whole.
import type { ModelTree } from "../../shared/model/modelTree";
import { isOver, statusLook, statusText } from "../../shared/run/controls";
import { inputText } from "../../shared/run/inputText";
import { selectionAt } from "../../shared/session/view";
import { follow, useCore, useSession, view } from "../client";
import { PastProperties } from "../past/PastProperties";
import { CodeText } from "./CodeText";
import { EndCard } from "./EndCard";
import { OpenCalls } from "./OpenCalls";
import { usePersonWait } from "./PersonWaitBar";
import { ValueTable } from "./ValueTable";

export function RunProperties({ tree }: { readonly tree: ModelTree | undefined }) {
  const core = useCore();
  const last = useSession((s) => s.lastInput);
  const past = useSession((s) => s.past?.past);
  const name = useSession((s) => s.model?.name);
  const asks = usePersonWait() !== undefined;
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
  return (
    <>
      <header className="prop-head">
        <small>Run {core.id}</small>
        <h2>{name === undefined || name === "" ? core.document : name}</h2>
        <span className={`pill is-${asks ? "paused" : statusLook(core)}`}>{asks && !core.paused ? "Waiting for a person" : statusText(core)}</span>
      </header>
      {interruption !== undefined && (
        <section className="interrupted" aria-label="Interrupted">
          <h3>Interrupted</h3>
          <p>
            <CodeText text={interruption.message} />
          </p>
        </section>
      )}
      <EndCard tree={tree} />
      {fault !== undefined && (
        <section className="fault" aria-label="Fault">
          <h3>Fault: {fault.kind}</h3>
          <p>{fault.message}</p>
          <button type="button" className="link" onClick={() => view.dispatch({ type: "jump", selection: (tree && selectionAt(tree, fault.at)) ?? { kind: "node", path: fault.at } })}>
            at {fault.at}
          </button>
        </section>
      )}
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
      <OpenCalls core={core} />
      {!isOver(core) && (
        <section>
          <h3>Document</h3>
          <p className="quiet">
            {core.document}, revision {core.revision}
          </p>
          <label className="follow">
            <input type="checkbox" checked={core.live} onChange={(event) => void follow(event.target.checked)} /> Follow edits while it runs
          </label>
          <p className="quiet">Each edit without errors then changes this run between its macro steps. A new port or action may move the robot.</p>
        </section>
      )}
      <ValueTable title="Arguments" values={core.arguments} names={Object.keys(core.arguments)} />
      <p className="quiet">Select a state, a barrier or a port to see its values.</p>
    </>
  );
}
