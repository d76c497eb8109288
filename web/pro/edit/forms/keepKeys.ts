// Keys that are pressed in a form and must not act on what is selected in the drawing.
import type { KeyboardEvent } from "react";

const kOwn: ReadonlySet<string> = new Set(["Delete", "Backspace"]);

export function keepKeys(event: KeyboardEvent): void {
  if (kOwn.has(event.key)) event.stopPropagation();
}
