// A layer over the drawing: what is in it is placed in the coordinates of the drawing, and moves with it.
import { useLayoutEffect, useRef, type ReactNode } from "react";
import { useShownCanvas } from "./canvasView";

export function CanvasLayer({ className, children }: { readonly className?: string; readonly children: ReactNode }) {
  const canvas = useShownCanvas();
  const layer = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    if (canvas === undefined) return;
    const place = () => {
      const { x, y, zoom } = canvas.viewport();
      if (layer.current !== null) layer.current.style.transform = `translate(${x}px, ${y}px) scale(${zoom})`;
    };
    place();
    return canvas.listen(place);
  }, [canvas]);
  return (
    <div className={`canvas-layer ${className ?? ""}`} ref={layer}>
      {children}
    </div>
  );
}
