// What others do on the drawing: an outline with their name around what they have selected, and their pointers.
import { useEffect } from "react";
import { shownBox } from "../../shared/drawing/drawnBox";
import { selectionsOf } from "../../shared/model/identity";
import { pointerAt } from "../../shared/presence/activity";
import { CanvasLayer } from "../canvas/CanvasLayer";
import { shownCanvas, useShownCanvas } from "../canvas/canvasView";
import type { Laid } from "../canvas/useDrawing";
import { others, useOfOthers, useOthers } from "./others";
import { pointAt, usePeople } from "./presence";

export function Others() {
  const laid = useShownCanvas()?.laid;
  const nobody = usePeople((people) => others(people).length === 0);
  usePointer();
  if (laid === undefined || nobody) return null;
  return (
    <CanvasLayer className="others">
      <Outlines laid={laid} />
      <Pointers laid={laid} />
    </CanvasLayer>
  );
}

function Outlines({ laid }: { readonly laid: Laid }) {
  const shown = useOfOthers((all) => all.map(({ name, person: { id, colour, selection } }) => ({ id, name, colour, selection: selection ?? [] })));
  const selections = selectionsOf(laid.tree);
  /** How many outlines are around the same element: each lies around the one before. */
  const around = new Map<string, number>();
  return shown.flatMap(({ id, name, colour, selection }) =>
    selection.map((element) => {
      const at = selections.get(element);
      const found = at && shownBox(laid.drawing, at);
      if (found === undefined) return null;
      const { x, y, width, height } = found.box;
      const key = `${x} ${y} ${width}`;
      const ring = around.get(key) ?? 0;
      around.set(key, ring + 1);
      return (
        <div key={`${id} ${element}`} className={`other-outline person-${colour}${found.inside ? " is-inside" : ""}`} data-person={id} data-element={element} data-ring={Math.min(ring, 3)} style={{ left: x, top: y, width, height }}>
          <span className="other-name">{name}</span>
        </div>
      );
    }),
  );
}

function Pointers({ laid }: { readonly laid: Laid }) {
  const all = useOthers();
  const selections = selectionsOf(laid.tree);
  return all.map(({ name, person: { id, colour, pointer } }) => {
    const at = pointer && selections.get(pointer.element);
    const found = at && shownBox(laid.drawing, at);
    if (pointer === undefined || found === undefined) return null;
    const { box, inside } = found;
    const [x, y] = inside ? [box.width / 2, box.height / 2] : [pointer.x, pointer.y];
    return (
      <div key={id} className={`other-pointer person-${colour}`} data-person={id} style={{ left: box.x + x, top: box.y + y }}>
        <svg viewBox="0 0 12 16" width="12" height="16" aria-hidden="true">
          <path d="M0 0 L12 9 L6.5 9.6 L4 15 Z" />
        </svg>
        <span className="other-name">{name}</span>
      </div>
    );
  });
}

/** Tells where the pointer of the person here is on the drawing. */
function usePointer(): void {
  const element = useShownCanvas()?.element;
  useEffect(() => {
    if (element === undefined) return undefined;
    const move = ({ clientX, clientY }: PointerEvent) => {
      const canvas = shownCanvas();
      const point = { x: clientX, y: clientY };
      const hit = canvas?.nodeAt(point);
      const node = canvas?.laid.drawing.nodes.find(({ path }) => path === hit?.path);
      const id = node && canvas?.laid.tree.get(node.path)?.node.id;
      pointAt(canvas === undefined || node === undefined || id === undefined ? undefined : pointerAt(id, node, canvas.toModel(point)));
    };
    const leave = () => pointAt(undefined);
    element.addEventListener("pointermove", move);
    element.addEventListener("pointerleave", leave);
    return () => {
      element.removeEventListener("pointermove", move);
      element.removeEventListener("pointerleave", leave);
      leave();
    };
  }, [element]);
}
