// The cursors of the fields of code that are on the page, without loading their editor.
import type { Span } from "../../shared/code/tokens";

export interface CodeCursor {
  readonly text: () => string;
  readonly position: () => number;
  /** Selects a part of the text, and shows it. */
  readonly select: (span: Span) => void;
}

const editors = new WeakMap<Element, CodeCursor>();

/** To be called by an editor for its element that takes the focus. */
export const registerCursor = (element: Element, cursor: CodeCursor): void => void editors.set(element, cursor);

const ofTextArea = (area: HTMLTextAreaElement): CodeCursor => ({ text: () => area.value, position: () => area.selectionStart, select: ({ from, to }) => area.setSelectionRange(from, to) });

/** Of an element that takes the focus: nothing, if it is no field of code. */
export const cursorOf = (element: Element): CodeCursor | undefined => editors.get(element) ?? (element instanceof HTMLTextAreaElement ? ofTextArea(element) : undefined);
