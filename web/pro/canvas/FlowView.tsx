// The canvas of React Flow as the canvas that is shown. Its names are enlarged when it is zoomed out.
import { useReactFlow, useStore, useStoreApi } from "@xyflow/react";
import { useLayoutEffect, useMemo } from "react";
import { canvasView, showCanvas } from "./canvasView";
import type { Laid } from "./useDrawing";

export function FlowView({ laid }: { readonly laid: Laid }) {
  const { setViewport } = useReactFlow();
  const store = useStoreApi();
  const element = useStore((s) => s.domNode);
  const view = useMemo(() => {
    if (element === null) return undefined;
    return canvasView({
      laid,
      element,
      viewport: () => {
        const [x, y, zoom] = store.getState().transform;
        return { x, y, zoom };
      },
      show: (viewport, duration = 0) => void setViewport(viewport, { duration }),
      listen: (listener) => store.subscribe((now, before) => now.transform !== before.transform && listener()),
    });
  }, [laid, element, setViewport, store]);
  useLayoutEffect(() => view && showCanvas(view), [view]);
  useLayoutEffect(() => {
    if (view === undefined) return;
    const { style } = view.element;
    const enlarge = () => {
      const { zoom } = view.viewport();
      style.setProperty("--least", String(0.5 / zoom));
      style.setProperty("--grow", String(Math.min(3, 0.72 / zoom)));
    };
    enlarge();
    return view.listen(enlarge);
  }, [view]);
  return null;
}
