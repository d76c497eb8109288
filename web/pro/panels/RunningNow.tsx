// What runs now, innermost states only, each with a jump.
import { useMemo } from "react";
import type { Core } from "../../generated/messages";
import { nameOf, type ModelTree } from "../../shared/model/modelTree";
import { runningNow } from "../../shared/run/applyDelta";
import { isOver } from "../../shared/run/controls";
import { isInterrupted } from "../../shared/run/interruption";
import { useCore, useSession, view } from "../client";

function headingOf(core: Core | undefined): string {
  if (core !== undefined && isInterrupted(core)) return "Active when interrupted";
  return core !== undefined && isOver(core) ? "Active at the end" : "Running now";
}

export function RunningNow({ tree }: { readonly tree: ModelTree | undefined }) {
  const state = useSession((s) => s.run);
  const core = useCore();
  const paths = useMemo(() => (state === undefined || tree === undefined ? [] : runningNow(state, tree)), [state, tree]);
  return (
    <section aria-label="Running now" className="running">
      <h2>{paths.length === 0 ? "Running now" : headingOf(core)}</h2>
      {paths.length === 0 ? (
        <p className="quiet">Nothing is active.</p>
      ) : (
        <ul>
          {paths.map((path) => (
            <li key={path}>
              <button type="button" onClick={() => view.dispatch({ type: "jump", selection: { kind: "node", path } })}>
                <i className="dot" aria-hidden="true" />
                <span title={path}>{nameOf(path)}</span>
                <small>
                  <bdi>{path.slice(0, -nameOf(path).length - 1)}</bdi>
                </small>
              </button>
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}
