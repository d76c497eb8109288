// The overview of a painted drawing in a corner, while it is needed, with the part that is seen; a press or drag moves there, the wheel zooms.
import { useEffect, useLayoutEffect, useRef, useSyncExternalStore, type PointerEvent, type RefObject } from "react";
import { areaOf, centredOn, wheelFactor, zoomedAt } from "../../../shared/drawing/movement";
import type { Size } from "../../../shared/drawing/measure";
import { needsMiniMap } from "../../../shared/drawing/miniMap";
import type { Scene } from "../../../shared/drawing/scene";
import { takeOver } from "../moved";
import type { Camera } from "./camera";
import { listenToTheme, readTheme } from "./theme";

interface Props {
  readonly scene: Scene;
  readonly size: Size;
  readonly camera: Camera;
  readonly movedRef: RefObject<boolean>;
}

const kSize = { width: 200, height: 150 };

/** How the drawing lies in the overview. */
function placeOf({ width, height }: Size) {
  const zoom = Math.min(kSize.width / width, kSize.height / height) * 0.94;
  return { zoom, x: (kSize.width - width * zoom) / 2, y: (kSize.height - height * zoom) / 2 };
}

function paint(canvas: HTMLCanvasElement, { drawing }: Scene): void {
  const context = canvas.getContext("2d");
  if (context === null) return;
  const { colours } = readTheme();
  const { x, y, zoom } = placeOf(drawing);
  const scale = devicePixelRatio;
  [canvas.width, canvas.height] = [kSize.width * scale, kSize.height * scale];
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.fillStyle = colours.panel;
  context.fillRect(0, 0, kSize.width, kSize.height);
  context.setTransform(scale * zoom, 0, 0, scale * zoom, scale * x, scale * y);
  for (const node of drawing.nodes) {
    context.fillStyle = node.depth === 0 ? colours["minimap-outer"] : colours["minimap-node"];
    context.fillRect(node.x, node.y, node.width, node.height);
  }
}

export function MiniMap(props: Props) {
  const { scene, size, camera } = props;
  const isNeeded = useSyncExternalStore(camera.listen, () => needsMiniMap(camera.viewport(), scene.drawing, size));
  return isNeeded ? <Overview {...props} /> : null;
}

function Overview({ scene, size, camera, movedRef }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const seen = useRef<HTMLDivElement>(null);
  const frame = useRef<HTMLDivElement>(null);
  const { drawing } = scene;

  useEffect(() => {
    const repaint = () => canvas.current !== null && paint(canvas.current, scene);
    repaint();
    return listenToTheme(repaint);
  }, [scene]);

  useLayoutEffect(() => {
    const place = () => {
      const area = areaOf(camera.viewport(), size);
      const { x, y, zoom } = placeOf(drawing);
      if (seen.current === null) return;
      seen.current.style.transform = `translate(${x + area.x * zoom}px, ${y + area.y * zoom}px)`;
      seen.current.style.width = `${Math.max(4, area.width * zoom)}px`;
      seen.current.style.height = `${Math.max(4, area.height * zoom)}px`;
    };
    place();
    return camera.listen(place);
  }, [camera, drawing, size]);

  useEffect(() => {
    const element = frame.current;
    const wheel = (event: WheelEvent) => {
      event.preventDefault();
      event.stopPropagation();
      takeOver(movedRef);
      camera.show(zoomedAt(camera.viewport(), { x: size.width / 2, y: size.height / 2 }, wheelFactor(event)));
    };
    element?.addEventListener("wheel", wheel, { passive: false });
    return () => element?.removeEventListener("wheel", wheel);
  }, [camera, size, movedRef]);

  const go = (event: PointerEvent<HTMLDivElement>) => {
    event.stopPropagation();
    if (event.buttons !== 1) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    const { left, top } = event.currentTarget.getBoundingClientRect();
    const { x, y, zoom } = placeOf(drawing);
    takeOver(movedRef);
    camera.show(centredOn({ x: (event.clientX - left - x) / zoom, y: (event.clientY - top - y) / zoom }, camera.viewport().zoom, size));
  };
  return (
    <div className="minimap" ref={frame} onPointerDown={go} onPointerMove={go} onClick={(event) => event.stopPropagation()} onDoubleClick={(event) => event.stopPropagation()}>
      <canvas ref={canvas} aria-hidden="true" />
      <div className="minimap-seen" ref={seen} />
    </div>
  );
}
