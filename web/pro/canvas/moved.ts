// The user has moved or zoomed the drawing: it is not fitted again, and no longer follows the run.
import type { RefObject } from "react";
import { view } from "../client";

export function takeOver(movedRef: RefObject<boolean>): void {
  movedRef.current = true;
  if (view.get().follow) view.dispatch({ type: "follow", on: false });
}
