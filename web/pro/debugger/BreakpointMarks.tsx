// The breakpoints in the drawing: a dot at each state and port that has some, over either canvas.
import { useMemo } from "react";
import { breakpointMarks, markOfClosed, type BreakpointMark } from "../../shared/debugger/places";
import type { Box } from "../../shared/drawing/drawing";
import { CanvasLayer } from "../canvas/CanvasLayer";
import { useShownCanvas } from "../canvas/canvasView";
import { useKept } from "./kept";

export function BreakpointMarks() {
  const laid = useShownCanvas()?.laid;
  const entries = useKept((kept) => kept.entries);
  const dots = useMemo(() => {
    if (laid === undefined || entries.length === 0) return [];
    const marks = breakpointMarks(laid.tree, entries.map(({ breakpoint }) => breakpoint));
    const at = (box: Box, mark: BreakpointMark | undefined) => (mark === undefined ? [] : [{ ...mark, box }]);
    return laid.drawing.nodes.flatMap((node) => [
      ...at(node, node.composite && !node.open ? markOfClosed(marks, node.path) : marks.get(node.path)),
      ...node.ports.flatMap((port) => at(port, marks.get(port.address))),
    ]);
  }, [laid, entries]);
  if (dots.length === 0) return null;
  return (
    <CanvasLayer className="breakpoint-marks">
      {dots.map(({ address, on, text, box }) => (
        <span key={address} role="img" className={`breakpoint-dot${on ? "" : " is-off"}`} data-breakpoint={address} aria-label={text} style={{ left: box.x, top: box.y }} />
      ))}
    </CanvasLayer>
  );
}
