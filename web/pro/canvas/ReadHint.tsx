// Says that the ports are too small to be read, while they are, and zooms in: to what is selected or active, else where one looks.
import { useSyncExternalStore, type RefObject } from "react";
import { becameActive } from "../../shared/drawing/follow";
import { hitIndex } from "../../shared/drawing/hit";
import { kPortsLegible } from "../../shared/drawing/levels";
import type { Size } from "../../shared/drawing/measure";
import { areaOf, centredOn } from "../../shared/drawing/movement";
import { pathOf } from "../../shared/session/view";
import { view } from "../client";
import { shownCanvas, useShownCanvas } from "./canvasView";
import { takeOver } from "./moved";
import type { Laid } from "./useDrawing";
import { liveNow } from "./useLive";

interface Props {
  readonly laid: Laid;
  readonly size: Size;
  readonly movedRef: RefObject<boolean>;
}

const never = () => () => undefined;

export function ReadHint({ laid, size, movedRef }: Props) {
  const canvas = useShownCanvas();
  const isSmall = useSyncExternalStore(canvas?.listen ?? never, () => canvas !== undefined && canvas.viewport().zoom < kPortsLegible * 0.999);
  if (!isSmall || laid.drawing.nodes.every(({ ports }) => ports.length === 0)) return null;
  const zoomIn = () => {
    const shown = shownCanvas();
    if (shown === undefined) return;
    takeOver(movedRef);
    const { selection } = view.get();
    const wanted = [...(selection === undefined ? [] : [pathOf(selection)]), ...becameActive(new Set(), liveNow().active)];
    const index = hitIndex(laid.drawing);
    const box = wanted.map((path) => index.node(path)).find((node) => node !== undefined) ?? areaOf(shown.viewport(), size);
    shown.show(centredOn({ x: box.x + box.width / 2, y: box.y + box.height / 2 }, 1, size), 300);
  };
  return (
    <button type="button" className="read-hint" title="The text of the ports is less than 10 pixels high" onClick={zoomIn}>
      Zoom in to read the ports
    </button>
  );
}
