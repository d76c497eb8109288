// Dragging a skill, or a step, to a place in a time line: with the mouse anywhere on its card, by touch at its grip. A store of what is dragged,
// and where it would go.
import { useState } from "react";
import type { SkillPlace } from "../../shared/timeline/changes/add";
import { createStore, useSelected } from "../../page/store";
import { dropSkill, dropStep } from "../step/actions";
import { createLastPress, pressHandlers, type PressHandlers } from "./press";

export type Dragged = { readonly kind: "skill"; readonly title: string; readonly place: SkillPlace } | { readonly kind: "step"; readonly title: string; readonly id: string };

/** The place among the steps of a composite. */
export interface DropPlace {
  readonly composite: string;
  readonly index: number;
}

interface Drag {
  readonly what: Dragged;
  readonly x: number;
  readonly y: number;
  readonly over: DropPlace | undefined;
}

const store = createStore<Drag | undefined, { readonly drag: Drag | undefined }>(undefined, (_, { drag }) => drag);
export const useDragged = <T>(select: (drag: Drag | undefined) => T): T => useSelected(store, select);

/** A press that moves less is none [px]. */
const kLeast = 8;

/** Where something that is let go at a point of the window would stand; `moved`: the step that is dragged does not count. */
function placeAt(x: number, y: number, moved: string | undefined): DropPlace | undefined {
  const line = document.elementFromPoint(x, y)?.closest<HTMLElement>("[data-composite]");
  if (line?.dataset["composite"] === undefined) return undefined;
  if (moved !== undefined && line.closest(`[data-step="${CSS.escape(moved)}"]`) !== null) return undefined;
  const cards = [...line.children].filter((card): card is HTMLElement => card instanceof HTMLElement && card.dataset["step"] !== undefined && card.dataset["step"] !== moved);
  const before = cards.findIndex((card) => {
    const box = card.getBoundingClientRect();
    const isColumn = getComputedStyle(line).flexDirection === "column";
    if (y < box.top) return true;
    if (y > box.bottom) return false;
    return isColumn ? y < box.top + box.height / 2 : x < box.left + box.width / 2;
  });
  return { composite: line.dataset["composite"], index: before === -1 ? cards.length : before };
}

function drop({ what, over }: Drag): void {
  if (over === undefined) return;
  if (what.kind === "skill") dropSkill(what.place, over);
  else dropStep(what.id, over);
}

/** Follows the pointer until it is let go; Escape gives up. */
function follow(event: React.PointerEvent, what: Dragged, onEnd: (dragged: boolean) => void): void {
  const { pointerId, clientX, clientY } = event;
  const ended = new AbortController();
  const end = (drops: boolean) => {
    const drag = store.get();
    ended.abort();
    store.dispatch({ drag: undefined });
    onEnd(drag !== undefined);
    if (drops && drag !== undefined) drop(drag);
  };
  const options = { signal: ended.signal };
  addEventListener(
    "pointermove",
    (moved) => {
      if (moved.pointerId !== pointerId) return;
      if (store.get() === undefined && Math.hypot(moved.clientX - clientX, moved.clientY - clientY) < kLeast) return;
      store.dispatch({ drag: { what, x: moved.clientX, y: moved.clientY, over: placeAt(moved.clientX, moved.clientY, what.kind === "step" ? what.id : undefined) } });
    },
    options,
  );
  addEventListener("pointerup", (up) => up.pointerId === pointerId && end(true), options);
  addEventListener("pointercancel", (up) => up.pointerId === pointerId && end(false), options);
  addEventListener("keydown", (key) => key.key === "Escape" && end(false), options);
}

export function useDrag(what: Dragged): PressHandlers<React.PointerEvent> {
  const [last] = useState(createLastPress);
  return pressHandlers(last, (event, onEnd) => follow(event, what, onEnd));
}
