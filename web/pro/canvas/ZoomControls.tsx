// Zooming by button and key: in, out, and the whole drawing; and the drawing as a file.
import type { RefObject } from "react";
import { fit } from "../../shared/drawing/fit";
import type { Size } from "../../shared/drawing/measure";
import { zoomedAt } from "../../shared/drawing/movement";
import { keysOf } from "../../shared/session/shortcuts";
import { useShortcuts } from "../useShortcuts";
import { shownCanvas } from "./canvasView";
import { showLegend, useLegend } from "./legend/Legend";
import { takeOver } from "./moved";
import { saveDrawing } from "./saveDrawing";
import type { Laid } from "./useDrawing";

const kMoment = 150;
const kStep = 1.2;

interface Props {
  readonly laid: Laid;
  readonly size: Size;
  /** Whether the user has moved or zoomed the drawing. */
  readonly movedRef: RefObject<boolean>;
}

export function ZoomControls({ laid, size, movedRef }: Props) {
  const legend = useLegend();
  const zoom = (factor: number) => {
    takeOver(movedRef);
    const canvas = shownCanvas();
    if (canvas === undefined) return;
    canvas.show(zoomedAt(canvas.target(), { x: size.width / 2, y: size.height / 2 }, factor), kMoment);
  };
  const fitAll = () => {
    movedRef.current = false;
    shownCanvas()?.show(fit(laid.drawing, size), 250);
  };
  useShortcuts((shortcut) => {
    switch (shortcut) {
      case "zoom_in":
        zoom(kStep);
        return true;
      case "zoom_out":
        zoom(1 / kStep);
        return true;
      case "fit":
        fitAll();
        return true;
      default:
        return false;
    }
  });
  return (
    <div className="zoom-controls" role="group" aria-label="Zoom">
      <Control label="Zoom In" title={`Zoom in (${keysOf("zoom_in")})`} sign="+" act={() => zoom(kStep)} />
      <Control label="Zoom Out" title={`Zoom out (${keysOf("zoom_out")})`} sign="−" act={() => zoom(1 / kStep)} />
      <Control label="Fit" title={`Show the whole drawing (${keysOf("fit")})`} path="M2 6V2h4M10 2h4v4M14 10v4h-4M6 14H2v-4" act={fitAll} />
      <Control label="Legend" title="Legend: what the signs mean" sign="i" pressed={legend} act={() => showLegend(!legend)} />
      <Control label="Save as SVG" title="Save the drawing as an SVG file" sign="↓" act={() => saveDrawing(laid)} />
    </div>
  );
}

interface ControlProps {
  readonly label: string;
  readonly title: string;
  /** What stands on it: a character, or a drawing. */
  readonly sign?: string;
  readonly path?: string;
  /** Whether what it shows is shown. */
  readonly pressed?: boolean;
  readonly act: () => void;
}

function Control({ label, title, sign, path, pressed, act }: ControlProps) {
  return (
    <button type="button" aria-label={label} title={title} aria-pressed={pressed} onClick={act}>
      {sign}
      {path !== undefined && (
        <svg viewBox="0 0 16 16" aria-hidden="true">
          <path d={path} fill="none" stroke="currentColor" strokeWidth="2" />
        </svg>
      )}
    </button>
  );
}
