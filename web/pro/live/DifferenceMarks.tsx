// Signs in the drawing where two documents differ: what is edited and what the run executes, or revisions.
import { useMemo } from "react";
import { drawnMarks } from "../../shared/live/drawnMarks";
import { CanvasLayer } from "../canvas/CanvasLayer";
import { useShownCanvas } from "../canvas/canvasView";
import { Ghosts } from "../versions/Ghosts";
import type { Compared } from "../../shared/edit/difference/compare";

/** More signs would hide the drawing. */
const kMost = 60;

export function DifferenceMarks({ compared }: { readonly compared: Compared }) {
  const laid = useShownCanvas()?.laid;
  const marks = useMemo(() => (laid === undefined ? [] : drawnMarks(compared, laid)), [laid, compared]);
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
