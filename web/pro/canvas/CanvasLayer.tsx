// A layer over the drawing: what is in it is placed in the coordinates of the drawing, and moves with it. `--zoom` says how large it is.
import { useLayoutEffect, useRef, type ReactNode } from "react";
import { useShownCanvas } from "./canvasView";

/** After the last movement it is drawn sharp, at its new size [ms]. */
const kSharp = 200;

export function CanvasLayer({ className, children }: { readonly className?: string; readonly children: ReactNode }) {
  const canvas = useShownCanvas();
  const layer = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    if (canvas === undefined) return;
    let before = 0;
    let resting: ReturnType<typeof setTimeout> | undefined;
    const place = () => {
      const { x, y, zoom } = canvas.viewport();
      const style = layer.current?.style;
      if (style === undefined) return;
      style.transform = `translate(${x}px, ${y}px) scale(${zoom})`;
      if (zoom !== before) style.setProperty("--zoom", String((before = zoom)));
    };
    place();
    const end = canvas.listen(() => {
      place();
      // While it moves, the browser's compositor moves it alone, and nothing is painted anew.
      layer.current?.style.setProperty("will-change", "transform");
      clearTimeout(resting);
      resting = setTimeout(() => layer.current?.style.removeProperty("will-change"), kSharp);
    });
    return () => {
      clearTimeout(resting);
      end();
    };
  }, [canvas]);
  return (
    <div className={`canvas-layer ${className ?? ""}`} ref={layer}>
      {children}
    </div>
  );
}
