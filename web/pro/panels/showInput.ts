// The way to what came in a macro step.
import { view } from "../client";
import { visit } from "../past/past";

/** Shows it among the calls and events, and the run as it was when it came. */
export function showInput(step: number): void {
  view.dispatch({ type: "drawer", drawer: "calls" });
  visit({ step, micro: 0 });
}
