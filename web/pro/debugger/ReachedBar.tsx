// Over the run bar: at which breakpoint the run is paused, and what goes on meanwhile.
import { useMemo } from "react";
import { breakpointText, reachedBy, selectionOf } from "../../shared/debugger/places";
import { view, useCore } from "../client";
import { useRunTree } from "../live/runTree";
import { useOwnName } from "../presence/ownName";

export function ReachedBar() {
  const core = useCore();
  const tree = useRunTree();
  const reached = useMemo(() => (core === undefined ? [] : reachedBy(core)), [core]);
  const own = useOwnName().name;
  const first = reached[0];
  if (first === undefined) return null;
  const selection = tree && selectionOf(tree, first);
  const text = breakpointText(tree, first);
  const show = () => {
    if (selection === undefined) return;
    view.dispatch({ type: "page", page: "task" });
    view.dispatch({ type: "jump", selection });
  };
  return (
    <div className="reached" role="status" aria-label="Breakpoint">
      <i className="breakpoint-dot is-on" aria-hidden="true" />
      <p>
        <strong>
          Paused: breakpoint at{" "}
          {selection === undefined ? (
            text
          ) : (
            <button type="button" className="link" onClick={show}>
              {text}
            </button>
          )}
          {first.author !== undefined && first.author !== own && ` of ${first.author}`}
          {reached.length > 1 && ` and ${reached.length - 1} more`}
        </strong>{" "}
        {first.condition !== undefined && (
          <>
            if <code>{first.condition}</code>.{" "}
          </>
        )}
        <span>Services and robots do not pause: open calls go on, and their time-outs run.</span>
      </p>
    </div>
  );
}
