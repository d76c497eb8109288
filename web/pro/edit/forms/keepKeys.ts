// Keys that are pressed in a form and must not act on what is selected in the drawing.
import type { KeyboardEvent } from "react";
import { canvasElement } from "../gestures/onScreen";

const kOwn: ReadonlySet<string> = new Set(["Delete", "Backspace"]);

export function keepKeys(event: KeyboardEvent): void {
  if (kOwn.has(event.key)) event.stopPropagation();
}

/** Esc leads back to the drawing; what is selected stays. A draft, a list and a completion take it first. */
export function leaveByEscape(event: KeyboardEvent): void {
  if (event.key !== "Escape" || event.defaultPrevented) return;
  event.stopPropagation();
  event.preventDefault();
  canvasElement()?.focus({ preventScroll: true });
}
