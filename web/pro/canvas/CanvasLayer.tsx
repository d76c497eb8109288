// A layer over the drawing: what is in it is placed in the coordinates of the drawing, and moves with it. `--zoom` says how large it is.
import { useLayoutEffect, useRef, type ReactNode } from "react";
import { useShownCanvas } from "./canvasView";

export function CanvasLayer({ className, children }: { readonly className?: string; readonly children: ReactNode }) {
  const canvas = useShownCanvas();
  const layer = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    if (canvas === undefined) return;
    let before = 0;
    const place = () => {
      const { x, y, zoom } = canvas.viewport();
      const style = layer.current?.style;
      if (style === undefined) return;
      style.transform = `translate(${x}px, ${y}px) scale(${zoom})`;
      if (zoom !== before) style.setProperty("--zoom", String((before = zoom)));
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
