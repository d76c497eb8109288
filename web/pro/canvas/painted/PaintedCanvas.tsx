// The canvas of a large drawing, painted: as Flow.tsx for the user, but without an element for each node and line.
import { memo, useEffect, useEffectEvent, useLayoutEffect, useMemo, useRef, useState, type RefObject } from "react";
import type { Hit } from "../../../shared/drawing/hit";
import { nodesInUse } from "../../../shared/drawing/inUse";
import { showsInside, showsPorts } from "../../../shared/drawing/levels";
import { areaOf } from "../../../shared/drawing/movement";
import type { Size } from "../../../shared/drawing/measure";
import { sceneOf, type Scene } from "../../../shared/drawing/scene";
import { selectedPaths } from "../../../shared/session/view";
import { useView, view } from "../../client";
import { useErrorCounts } from "../../edit/errors";
import { canvasView, showCanvas, type CanvasView } from "../canvasView";
import { doubleClicked } from "../doubleClick";
import { takeOver } from "../moved";
import type { Laid } from "../useDrawing";
import { createCamera, type Camera } from "./camera";
import { InUse } from "./InUse";
import { MiniMap } from "./MiniMap";
import { Painter } from "./Painter";
import { toggleBox } from "./paintNode";
import { listenToPointers } from "./pointing";

interface Props {
  readonly laid: Laid;
  readonly size: Size;
  /** Whether the user has moved or zoomed the drawing. */
  readonly movedRef: RefObject<boolean>;
}

/** The view has been at rest for so long when elements are made for what can be read [ms]. */
const kSettled = 150;

/** What is painted for a hit: the outermost composite whose inside is too small to be painted, and a port only if ports are. */
function seenIn(scene: Scene, camera: Camera): (hit: Hit) => Hit {
  return ({ path, port }) => {
    const { zoom } = camera.viewport();
    let found = scene.node(path);
    while (found?.inside !== undefined && !showsInside(found.inside, zoom)) found = scene.node(found.inside.path);
    if (found?.node.path !== path) return { path: found?.node.path ?? path };
    return port !== undefined && showsPorts(found.node, zoom) ? { path, port } : { path };
  };
}

function clicked(canvas: CanvasView, scene: Scene, event: MouseEvent): void {
  const hit = canvas.nodeAt({ x: event.clientX, y: event.clientY });
  const node = hit && scene.node(hit.path)?.node;
  if (hit === undefined || node === undefined) {
    view.dispatch({ type: "select", selection: undefined });
    return;
  }
  const { zoom } = canvas.viewport();
  const toggle = toggleBox(node, zoom);
  const point = canvas.toModel({ x: event.clientX, y: event.clientY });
  const toggled = node.composite && hit.port === undefined && point.x >= toggle.x && point.y >= toggle.y && point.x <= toggle.x + toggle.width && point.y <= toggle.y + toggle.height;
  if (toggled && showsInside(node, zoom)) view.dispatch({ type: "toggle", path: hit.path });
  else view.dispatch({ type: "select", selection: hit.port === undefined ? { kind: "node", path: hit.path } : { kind: "port", address: hit.port } });
}

/** Where the pointer is. */
function useHover() {
  const [hover, setHover] = useState<Hit>();
  const at = (hit: Hit | undefined) => setHover((before) => (before?.path === hit?.path && before?.port === hit?.port ? before : hit));
  return [hover, at] as const;
}

/** The nodes that have elements, made anew when the view has come to rest or something else is in use. */
function useNodesInUse(scene: Scene, camera: Camera, size: Size, used: readonly (string | undefined)[]) {
  const [rest, setRest] = useState(camera.viewport);
  useEffect(() => {
    let waiting: ReturnType<typeof setTimeout> | undefined;
    const end = camera.listen(() => {
      clearTimeout(waiting);
      waiting = setTimeout(() => setRest(camera.viewport()), kSettled);
    });
    return () => {
      clearTimeout(waiting);
      end();
    };
  }, [camera]);
  const key = used.filter((path) => path !== undefined).join("\n");
  const paths = useMemo(() => nodesInUse(scene, areaOf(rest, size), rest.zoom, key === "" ? [] : key.split("\n")), [scene, rest, size, key]);
  return { paths, zoom: rest.zoom };
}

const isOnButton = (event: Event): boolean => event.target instanceof Element && event.target.closest("button") !== null;

export const PaintedCanvas = memo(function PaintedCanvas({ laid, size, movedRef }: Props) {
  const frame = useRef<HTMLDivElement>(null);
  const overview = useRef<HTMLCanvasElement>(null);
  const one = useRef<HTMLCanvasElement>(null);
  const other = useRef<HTMLCanvasElement>(null);
  const live = useRef<HTMLCanvasElement>(null);
  const [camera] = useState(createCamera);
  const [painter, setPainter] = useState<Painter>();
  const [hover, setHover] = useHover();
  const [focused, setFocused] = useState<string>();
  const scene = useMemo(() => sceneOf(laid.drawing, laid.tree), [laid]);
  const selection = useView((v) => v.selection);
  const also = useView((v) => v.also);
  const errors = useErrorCounts();

  useLayoutEffect(() => {
    if (frame.current === null || overview.current === null || one.current === null || other.current === null || live.current === null) return;
    const made = new Painter({ frame: frame.current, overview: overview.current, pictures: [one.current, other.current], live: live.current }, camera);
    setPainter(made);
    return () => made.close();
  }, [camera]);

  useLayoutEffect(() => {
    if (frame.current === null) return;
    return showCanvas(canvasView({ laid, element: frame.current, ...camera }, seenIn(scene, camera)));
  }, [laid, scene, camera]);

  useLayoutEffect(() => {
    const nodes = selection?.kind === "node" ? [selection.path, ...also] : [];
    painter?.show({ scene, size, marks: { nodes, port: selection?.kind === "port" ? selection.address : undefined, hovered: hover?.port, errors } });
  }, [painter, scene, size, selection, also, hover, errors]);

  const current = useEffectEvent(() => {
    const element = frame.current;
    return element === null ? undefined : canvasView({ laid, element, ...camera }, seenIn(scene, camera));
  });
  const onClick = useEffectEvent((event: MouseEvent) => {
    const canvas = current();
    if (canvas !== undefined && !isOnButton(event)) clicked(canvas, scene, event);
  });
  const onDoubleClick = useEffectEvent((event: MouseEvent) => {
    const hit = current()?.nodeAt({ x: event.clientX, y: event.clientY });
    if (hit === undefined) return;
    const inside = hit.port === undefined && scene.node(hit.path)?.node.composite === true ? hit.path : undefined;
    doubleClicked(event, hit.port === undefined ? { kind: "node", path: hit.path } : { kind: "port", address: hit.port }, inside);
  });
  const onHover = useEffectEvent((event: PointerEvent | undefined) => setHover(event && current()?.nodeAt({ x: event.clientX, y: event.clientY })));
  useEffect(() => {
    if (frame.current === null) return;
    const onMove = () => takeOver(movedRef);
    return listenToPointers(frame.current, camera, { onMove, onClick: (e) => onClick(e), onDoubleClick: (e) => onDoubleClick(e), onHover: (e) => onHover(e) });
  }, [camera, movedRef]);

  const selected = useView((v) => selectedPaths(v)[0] ?? (v.selection?.kind === "port" ? v.selection.address.slice(0, v.selection.address.lastIndexOf(".")) : undefined));
  const inUse = useNodesInUse(scene, camera, size, [selected, focused, hover?.path]);
  return (
    <>
      <div className="painted" ref={frame} onFocus={({ target }) => setFocused(target.closest<HTMLElement>("[data-path]")?.dataset["path"])} onBlur={() => setFocused(undefined)}>
      <canvas ref={overview} aria-hidden="true" />
      <canvas ref={one} aria-hidden="true" />
      <canvas ref={other} aria-hidden="true" />
      <canvas ref={live} aria-hidden="true" className="painted-live" />
      <InUse scene={scene} paths={inUse.paths} zoom={inUse.zoom} />
    </div>
    <MiniMap scene={scene} size={size} camera={camera} movedRef={movedRef} />
    </>
  );
});
