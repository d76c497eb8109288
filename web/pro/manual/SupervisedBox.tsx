// Whether the runs that are begun need the person at the controls.
import { isOwn } from "../../shared/control/texts";
import { useStop } from "../../stop/useStop";
import { supervise, useSupervised } from "../../control/supervised";

export function SupervisedBox() {
  const on = useSupervised();
  const isMine = useStop((stop) => isOwn(stop.holder, stop.held));
  const isAlways = useStop((stop) => stop.mode === "programming");
  return (
    <label title={isAlways ? "In programming mode every run is" : "Without you at the controls, nothing moves by the run, and it is paused"}>
      <input type="checkbox" checked={on || (isAlways && isMine)} disabled={!isMine || isAlways} onChange={(event) => supervise(event.target.checked)} />
      Supervised: it moves only while I have the controls{isMine ? "" : " (take them first)"}
    </label>
  );
}
