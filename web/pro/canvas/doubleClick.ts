// A double click on the drawing of a run: it shows the properties, with Ctrl it enters, as in the editor (edit/gestures/EditCanvas.tsx).
import type { MouseEvent as ReactMouseEvent } from "react";
import { flushSync } from "react-dom";
import type { Selection } from "../../shared/model/identity";
import { view } from "../client";
import { showProperties } from "../panels/showProperties";

/** `inside`: the state that can be entered, if it is a composite. */
export function doubleClicked({ ctrlKey, metaKey }: Pick<MouseEvent | ReactMouseEvent, "ctrlKey" | "metaKey">, selection: Selection, inside: string | undefined): void {
  if (ctrlKey || metaKey) {
    if (inside !== undefined) view.dispatch({ type: "enter", path: inside });
    return;
  }
  // Its properties are there before the focus goes to them.
  flushSync(() => view.dispatch({ type: "select", selection }));
  showProperties();
}
