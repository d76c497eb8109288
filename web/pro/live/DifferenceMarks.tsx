// Signs in the drawing where two documents differ: what is edited and what the run executes, or revisions.
import { useMemo } from "react";
import { markOf, rowsByPlace } from "../../shared/live/marks";
import { selectionsOf, type Selection } from "../../shared/model/identity";
import type { Box } from "../../shared/drawing/drawing";
import { CanvasLayer } from "../canvas/CanvasLayer";
import { useShownCanvas } from "../canvas/canvasView";
import type { Laid } from "../canvas/useDrawing";
import { Ghosts } from "../versions/Ghosts";
import type { Compared } from "../../shared/edit/difference/compare";

/** More signs would hide the drawing. */
const kMost = 60;

/** What is drawn of nodes and ports, by path and address. */
const boxesOf = ({ drawing }: Laid): ReadonlyMap<string, Box> =>
  new Map(drawing.nodes.flatMap((node): readonly (readonly [string, Box])[] => [[node.path, node], ...node.ports.map((port): readonly [string, Box] => [port.address, port])]));

const addressOf = (selection: Selection): string => (selection.kind === "node" ? selection.path : selection.address);

export function DifferenceMarks({ compared }: { readonly compared: Compared }) {
  const laid = useShownCanvas()?.laid;
  const marks = useMemo(() => {
    if (laid === undefined) return [];
    const [boxes, selections] = [boxesOf(laid), selectionsOf(laid.tree)];
    const boxAt = (id: string) => {
      const selection = selections.get(id);
      return selection && boxes.get(addressOf(selection));
    };
    const places = rowsByPlace(compared.before, compared.after, compared.rows, (id) => boxAt(id) !== undefined);
    return [...places].flatMap(([id, rows]) => {
      const box = boxAt(id);
      return box === undefined ? [] : [{ id, box, ...markOf(id, rows) }];
    });
  }, [laid, compared]);
  return (
    <CanvasLayer className="difference-marks">
      {laid !== undefined && <Ghosts compared={compared} laid={laid} />}
      {marks.slice(0, kMost).map(({ id, box, kind, sign, text }) => (
        <span key={id} role="img" className={`difference-mark is-${kind}`} data-mark={id} aria-label={text} title={text} style={{ left: box.x + box.width, top: box.y }}>
          {sign}
        </span>
      ))}
    </CanvasLayer>
  );
}
