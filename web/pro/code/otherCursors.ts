// The cursors of others in a text of code: each stays at its place while the text is typed, until it is told anew.
import { EditorSelection, StateEffect, StateField, type Extension } from "@codemirror/state";
import { layer, RectangleMarker, showTooltip, type EditorView, type Tooltip } from "@codemirror/view";
import type { OtherCursor } from "./CodeField";

const setCursors = StateEffect.define<readonly OtherCursor[]>();

/** The lines, in a layer over the text: they are no part of it. */
const lines = layer({
  above: true,
  class: "other-cursors",
  update: ({ docChanged, geometryChanged, transactions }) => docChanged || geometryChanged || transactions.some(({ effects }) => effects.some((effect) => effect.is(setCursors))),
  markers: (view) => view.state.field(cursors).flatMap(({ offset, colour }) => RectangleMarker.forRange(view, `other-cursor person-${colour}`, EditorSelection.cursor(offset))),
});

/** The name above it, outside of the field, which may be one line high. */
function nameAt({ offset, name, colour }: OtherCursor): Tooltip {
  const create = () => {
    const dom = document.createElement("div");
    dom.className = `other-cursor-name person-${colour}`;
    dom.textContent = name;
    dom.setAttribute("aria-hidden", "true");
    return { dom };
  };
  return { pos: offset, above: true, create };
}

const cursors = StateField.define<readonly OtherCursor[]>({
  create: () => [],
  update(before, { effects, docChanged, changes, newDoc }) {
    const told = effects.find((effect) => effect.is(setCursors));
    if (told !== undefined) return told.value.map((each) => ({ ...each, offset: Math.min(each.offset, newDoc.length) }));
    return docChanged ? before.map((each) => ({ ...each, offset: changes.mapPos(each.offset, 1) })) : before;
  },
  provide: (field) => showTooltip.computeN([field], (state) => state.field(field).map(nameAt)),
});

export const otherCursors: Extension = [cursors, lines];

export const showCursors = (view: EditorView, told: readonly OtherCursor[]): void => view.dispatch({ effects: setCursors.of(told) });
