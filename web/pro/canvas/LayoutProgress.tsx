// Shows the progress of a long layout and cancels it: the view then returns to the previous drawing.
import { view } from "../client";
import { useShortcuts } from "../useShortcuts";
import type { Laid, Progress } from "./useDrawing";

interface Props {
  readonly progress: Progress;
  /** The drawing that stays meanwhile. */
  readonly laid: Laid;
}

export function LayoutProgress({ progress, laid }: Props) {
  const cancel = () => view.dispatch({ type: "show_again", shown: laid.shows });
  useShortcuts((shortcut) => {
    if (shortcut !== "escape") return false;
    cancel();
    return true;
  });
  return (
    <div className="layout-progress" role="status" aria-label="Drawing">
      <span>Drawing the model…</span>
      <progress value={progress.done} max={progress.of} />
      <button type="button" title="Keep the drawing as it is (Esc)" onClick={cancel}>
        Cancel
      </button>
    </div>
  );
}
