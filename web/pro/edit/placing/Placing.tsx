// Placing states and writing notes in the drawing of the document that is edited: the pointer and buttons for it; its keys are actions.
import { useEffect, useEffectEvent } from "react";
import { useShownCanvas } from "../../canvas/canvasView";
import { useView } from "../../client";
import { useRefusal } from "../../login/rights";
import { runAction } from "../actions/action";
import { actionOf } from "../actions/registry";
import { dragFrom } from "./dragNodes";
import { levelPath } from "./level";
import { Notes } from "./Notes";
import { useEditedPlaces } from "./editedPlaces";

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
  return canvas === undefined ? null : <Notes />;
}

export function PlacingTools() {
  const laid = useShownCanvas()?.laid;
  const shown = useView((now) => now);
  const places = useEditedPlaces();
  const refusal = useRefusal("edit");
  const refused = refusal !== undefined;
  if (laid === undefined) return null;
  const path = levelPath(laid, shown);
  const children = laid.tree.get(path)?.children ?? [];
  const placed = children.filter(({ node: { id } }) => id !== undefined && places.has(id)).length;
  return (
    <div className="canvas-group" role="group" aria-label="Places">
      <button type="button" disabled={placed === 0 || refused} title={refusal ?? `Lays the states in ${path} out automatically (Ctrl+Alt+L)`} onClick={() => runAction(actionOf("lay_out_anew"))}>
        Lay out anew
      </button>
      <button type="button" disabled={children.length === 0 || placed === children.length || refused} title={refusal ?? `Keeps the states in ${path} where they are`} onClick={() => runAction(actionOf("keep_layout"))}>
        Keep layout
      </button>
      <button type="button" disabled={refused} title={refusal ?? "Notes something about what is selected (Shift+F2)"} onClick={() => runAction(actionOf("note"))}>
        Note
      </button>
    </div>
  );
}
