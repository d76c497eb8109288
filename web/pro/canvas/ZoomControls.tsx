// Zooming by button and key: in, out, and the whole drawing.
import { ControlButton, Controls, useReactFlow, useStore } from "@xyflow/react";
import type { RefObject } from "react";
import { fit } from "../../shared/drawing/fit";
import { keysOf } from "../../shared/session/shortcuts";
import { useShortcuts } from "../useShortcuts";
import type { Laid } from "./useDrawing";

const kMoment = { duration: 150 };

interface Props {
  readonly laid: Laid;
  /** Whether the user has moved or zoomed the drawing. */
  readonly movedRef: RefObject<boolean>;
}

export function ZoomControls({ laid, movedRef }: Props) {
  const { setViewport, zoomIn, zoomOut } = useReactFlow();
  const width = useStore((s) => s.width);
  const height = useStore((s) => s.height);
  const move = () => {
    movedRef.current = true;
  };
  const fitAll = () => {
    movedRef.current = false;
    void setViewport(fit(laid.drawing, { width, height }), { duration: 250 });
  };
  useShortcuts((shortcut) => {
    switch (shortcut) {
      case "zoom_in":
        move();
        void zoomIn(kMoment);
        return true;
      case "zoom_out":
        move();
        void zoomOut(kMoment);
        return true;
      case "fit":
        fitAll();
        return true;
      default:
        return false;
    }
  });
  return (
    <Controls showInteractive={false} showFitView={false} position="bottom-left" onZoomIn={move} onZoomOut={move}>
      <ControlButton aria-label="Fit" title={`Show the whole drawing (${keysOf("fit")})`} onClick={fitAll}>
        <svg viewBox="0 0 16 16" aria-hidden="true">
          <path d="M2 6V2h4M10 2h4v4M14 10v4h-4M6 14H2v-4" fill="none" stroke="currentColor" strokeWidth="2" />
        </svg>
      </ControlButton>
    </Controls>
  );
}
