// Where states stand in the drawing, by key; and notes.
import type { Command } from "../../../shared/edit/commands/command";
import { keepLayout, layOutAnew, moveNodes } from "../../../shared/edit/commands/placing";
import { selectedPaths } from "../../../shared/session/view";
import { shownCanvas } from "../../canvas/canvasView";
import type { Laid } from "../../canvas/useDrawing";
import { levelPath } from "../placing/level";
import { editNote, noted } from "../placing/noted";
import type { Situation } from "../situation";
import type { Action } from "./action";
import { commandAction, type ActionSpec } from "./commandAction";

const kNotDrawn = "the drawing is not here yet";

/** How far a key moves what is selected [px]. */
const kStep = 8;

/** A command on what is drawn. */
const drawnAction = (spec: Omit<ActionSpec, "group">, make: (laid: Laid, situation: Situation) => Command): Action =>
  commandAction({ ...spec, group: "Place" }, (situation) => {
    const laid = shownCanvas()?.laid;
    return laid === undefined ? { reason: kNotDrawn } : make(laid, situation);
  });

const nudge = (name: string, key: string, x: number, y: number): Action =>
  drawnAction({ id: `place_${name}`, name: `Place it farther ${name}`, keys: [key], repeats: true }, ({ drawing, tree }, { view }) => {
    const paths = selectedPaths(view);
    return paths.length === 0 ? { reason: "nothing is selected" } : moveNodes(drawing, tree, paths, { x: x * kStep, y: y * kStep });
  });

const noting: Action = {
  id: "note", name: "Write a note beside it", keys: ["Shift+F2"], group: "Place", where: "model",
  when: () => (shownCanvas() === undefined ? kNotDrawn : undefined),
  run: ({ view }) => {
    const laid = shownCanvas()?.laid;
    if (laid !== undefined) editNote(noted(laid, view));
  },
};

export const placingActions: readonly Action[] = [
  nudge("left", "Ctrl+ArrowLeft", -1, 0),
  nudge("right", "Ctrl+ArrowRight", 1, 0),
  nudge("up", "Ctrl+ArrowUp", 0, -1),
  nudge("down", "Ctrl+ArrowDown", 0, 1),
  drawnAction({ id: "lay_out_anew", name: "Lay out anew", keys: ["Ctrl+Alt+L"], where: "untyped" }, (laid, { tree, view }) => layOutAnew(tree, laid.tree, levelPath(laid, view))),
  drawnAction({ id: "keep_layout", name: "Keep layout", where: "untyped" }, (laid, { view }) => keepLayout(laid.drawing, laid.tree, levelPath(laid, view))),
  noting,
];
