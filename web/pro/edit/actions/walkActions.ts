// Going through the drawing by key.
import { walk, type Way } from "../../../shared/edit/walk";
import { view } from "../../client";
import { focusSelected } from "../gestures/focused";
import { boxOf, canvasElement } from "../gestures/onScreen";
import type { Selection } from "../../../shared/model/identity";
import type { Action } from "./action";

/** Whether it is drawn, and in the part of the drawing that is shown. */
function isShown(selection: Selection): boolean {
  const [box, frame] = [boxOf(selection), canvasElement()?.getBoundingClientRect()];
  return box !== undefined && frame !== undefined && box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom;
}

const walkAction = (way: Way, name: string, keys: readonly string[]): Action => ({
  id: `walk_${way}`, name, keys, group: "Walk", where: "model", repeats: true,
  when: () => undefined,
  run: ({ model, view: { selection }, focus }) => {
    const next = walk(model, selection, focus.path, way);
    if (next === undefined) return;
    view.dispatch({ type: isShown(next) ? "select" : "jump", selection: next });
    focusSelected();
  },
});

export const walkActions: readonly Action[] = [
  walkAction("next", "Next beside it", ["ArrowRight"]),
  walkAction("previous", "Previous beside it", ["ArrowLeft"]),
  walkAction("in", "Into it", ["ArrowDown"]),
  walkAction("out", "Out of it", ["ArrowUp"]),
  walkAction("ports", "To its ports", ["Shift+ArrowDown"]),
];
