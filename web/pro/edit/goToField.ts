// To a field of the document that is edited: its element is selected, so that its form is there, and the field has the focus.
import { flushSync } from "react-dom";
import type { Span } from "../../shared/code/tokens";
import { cursorOf } from "../code/cursor";
import { view } from "../client";
import { unfold } from "../layout/panels";
import { showTop } from "./editing";
import { selectById } from "./forms/selectById";

const fieldAt = (place: string): HTMLElement | null => document.querySelector<HTMLElement>(`[data-place="${CSS.escape(place)}"]`);

function showElement(id: string): void {
  if (id !== "") {
    selectById(id);
    return;
  }
  showTop(undefined);
  view.dispatch({ type: "select", selection: undefined });
}

/** The first of `fields` that the form of the element has; empty `id`: the document. `span`: what is selected in its text. */
export function goToField(id: string, fields: readonly string[], span?: Span): void {
  unfold("right");
  flushSync(() => showElement(id));
  const found = fields.map((field) => fieldAt(`${id}/${field}`)).find((field) => field !== null);
  if (found === undefined) return;
  found.focus();
  found.scrollIntoView({ block: "nearest" });
  if (span !== undefined) cursorOf(found)?.select(span);
}
