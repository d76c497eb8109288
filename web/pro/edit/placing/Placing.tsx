// Placing states and writing notes in the drawing of the document that is edited: the pointer, keys and buttons for it.
import { useEffect, useEffectEvent } from "react";
import { keepLayout, layOutAnew, moveNodes } from "../../../shared/edit/commands/placing";
import { selectedPaths } from "../../../shared/session/view";
import { shownCanvas, useShownCanvas } from "../../canvas/canvasView";
import { useView, view } from "../../client";
import { isTyping } from "../../useShortcuts";
import { editedDocument } from "../editing";
import { carryOut } from "./carryOut";
import { dragFrom } from "./dragNodes";
import { levelPath } from "./level";
import { Notes } from "./Notes";
import { editNote, noted } from "./noted";
import { useEditedPlaces } from "./editedPlaces";

/** How far a key moves what is selected [px]. */
const kStep = 8;
const kArrows: Readonly<Record<string, { readonly x: number; readonly y: number }>> = {
  ArrowLeft: { x: -kStep, y: 0 },
  ArrowRight: { x: kStep, y: 0 },
  ArrowUp: { x: 0, y: -kStep },
  ArrowDown: { x: 0, y: kStep },
};

function anew(): void {
  const [laid, document] = [shownCanvas()?.laid, editedDocument()];
  if (laid !== undefined && document !== undefined) carryOut(layOutAnew(document, laid.tree, levelPath(laid, view.get())));
}

function keep(): void {
  const laid = shownCanvas()?.laid;
  if (laid !== undefined) carryOut(keepLayout(laid.drawing, laid.tree, levelPath(laid, view.get())));
}

/** Whether the key was for the drawing. */
function press(event: KeyboardEvent): boolean {
  const laid = shownCanvas()?.laid;
  if (laid === undefined || view.get().page !== "edit" || event.defaultPrevented || isTyping(event.target)) return false;
  const control = event.ctrlKey || event.metaKey;
  if (event.key === "F2" && event.shiftKey) return (editNote(noted(laid, view.get())), true);
  if (control && event.altKey && event.code === "KeyL") return (anew(), true);
  const by = kArrows[event.key];
  if (!control || event.altKey || event.shiftKey || by === undefined || selectedPaths(view.get()).length === 0) return false;
  carryOut(moveNodes(laid.drawing, laid.tree, selectedPaths(view.get()), by, 1));
  return true;
}

export function Placing() {
  const canvas = useShownCanvas();
  const drag = useEffectEvent((event: PointerEvent) => canvas !== undefined && dragFrom(canvas, event));
  const element = canvas?.element;
  useEffect(() => {
    if (element === undefined) return;
    const listener = (event: PointerEvent) => drag(event);
    element.addEventListener("pointerdown", listener, true);
    return () => element.removeEventListener("pointerdown", listener, true);
  }, [element]);
  useEffect(() => {
    const listener = (event: KeyboardEvent) => press(event) && event.preventDefault();
    addEventListener("keydown", listener);
    return () => removeEventListener("keydown", listener);
  }, []);
  if (canvas === undefined) return null;
  return (
    <>
      <PlacingTools />
      <Notes />
    </>
  );
}

function PlacingTools() {
  const laid = useShownCanvas()?.laid;
  const shown = useView((now) => now);
  const places = useEditedPlaces();
  if (laid === undefined) return null;
  const path = levelPath(laid, shown);
  const children = laid.tree.get(path)?.children ?? [];
  const placed = children.filter(({ node: { id } }) => id !== undefined && places.has(id)).length;
  return (
    <div className="canvas-tools placing-tools" role="toolbar" aria-label="Places">
      <button type="button" disabled={placed === 0} title={`Lays the states in ${path} out automatically (Ctrl+Alt+L)`} onClick={anew}>
        Lay out anew
      </button>
      <button type="button" disabled={children.length === 0 || placed === children.length} title={`Keeps the states in ${path} where they are`} onClick={keep}>
        Keep layout
      </button>
      <button type="button" title="Notes something about what is selected (Shift+F2)" onClick={() => editNote(noted(laid, view.get()))}>
        Note
      </button>
    </div>
  );
}
