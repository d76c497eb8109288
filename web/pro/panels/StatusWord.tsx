// The status of the run in a word or two; of a run that is over, the way to how it ended.
import { flushSync } from "react-dom";
import type { Core } from "../../generated/messages";
import { isOver, statusText } from "../../shared/run/controls";
import { lastStatusText } from "../../shared/run/lostText";
import { view } from "../client";
import { unfold } from "../layout/panels";
import { toPresent } from "../past/past";

interface Props {
  readonly core: Core;
  readonly lost: boolean;
  /** What the run waits for a person for. */
  readonly asks: string | undefined;
}

/** The properties of the run, with the cards of its end and its fault: they are shown of the present, while nothing is selected. */
function showEnd(): void {
  unfold("right");
  toPresent();
  flushSync(() => {
    view.dispatch({ type: "page", page: "task" });
    view.dispatch({ type: "select", selection: undefined });
  });
  document.querySelector(".fault, .end-card")?.scrollIntoView({ block: "nearest" });
}

export function StatusWord({ core, lost, asks }: Props) {
  const text = lost ? lastStatusText(core) : asks !== undefined && !core.paused ? asks : statusText(core);
  if (!isOver(core)) return <strong>{text}</strong>;
  return (
    <button type="button" className="link" title="Show how it ended" onClick={showEnd}>
      <strong>{text}</strong>
    </button>
  );
}
