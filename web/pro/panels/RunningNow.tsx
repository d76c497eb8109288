// What runs now, innermost states only, each with a jump.
import { useMemo } from "react";
import type { Core } from "../../generated/messages";
import { nameOf, type ModelTree } from "../../shared/model/modelTree";
import { stateShown } from "../../shared/past/shown";
import { runningNow } from "../../shared/run/applyDelta";
import { isOver } from "../../shared/run/controls";
import { isInterrupted } from "../../shared/run/interruption";
import { useCore, useSession, view } from "../client";

/** More are not listed: there may be thousands, each of them lit in the tree. */
const kMost = 12;

function headingOf(core: Core | undefined, isPast: boolean, isLost: boolean): string {
  if (isPast) return "Active then";
  if (isLost && core?.status === "running") return "Active when last heard of";
  if (core !== undefined && isInterrupted(core)) return "Active when interrupted";
  return core !== undefined && isOver(core) ? "Active at the end" : "Running now";
}

export function RunningNow({ tree }: { readonly tree: ModelTree | undefined }) {
  const state = useSession(stateShown);
  const core = useCore();
  const past = useSession((s) => s.past !== undefined);
  const lost = useSession((s) => s.connection === "lost");
  const paths = useMemo(() => (state === undefined || tree === undefined ? [] : runningNow(state, tree)), [state, tree]);
  return (
    <section aria-label="Running now" className="running">
      <h2>{paths.length === 0 && !past ? "Running now" : headingOf(core, past, lost)}</h2>
      {paths.length === 0 ? (
        <p className="quiet">{past ? "Nothing was active." : "Nothing is active."}</p>
      ) : (
        <ul>
          {paths.slice(0, kMost).map((path, i) => (
            // The rows stay while a run goes on, and say something else.
            <li key={i}>
              <button type="button" title={path} data-inside={`\u200e${path.slice(0, -nameOf(path).length - 1)}`} onClick={() => view.dispatch({ type: "jump", selection: { kind: "node", path } })}>
                {nameOf(path)}
              </button>
            </li>
          ))}
          {paths.length > kMost && <li className="quiet">and {paths.length - kMost} more, lit in the tree</li>}
        </ul>
      )}
    </section>
  );
}
