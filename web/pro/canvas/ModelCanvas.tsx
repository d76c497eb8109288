// The canvas: the laid out model with zoom, pan, breadcrumb and the state of the run.
import { Background, BackgroundVariant, MiniMap, ReactFlow, ReactFlowProvider, useReactFlow, useStore, type NodeTypes, type EdgeTypes } from "@xyflow/react";
import { memo, useEffect, useEffectEvent, useMemo, useRef, type CSSProperties, type RefObject } from "react";
import { fit, fitReadable } from "../../shared/drawing/fit";
import { flowLines, flowNodes } from "../../shared/drawing/flow";
import { kNoPlaces, type Places } from "../../shared/drawing/places";
import type { ModelTree } from "../../shared/model/modelTree";
import { pathOf } from "../../shared/session/view";
import { useView, view } from "../client";
import { BarrierNode, type BarrierFlowNode } from "./BarrierNode";
import { Breadcrumb } from "./Breadcrumb";
import { CanvasTools } from "./CanvasTools";
import { FlowView } from "./FlowView";
import { LayoutProgress } from "./LayoutProgress";
import { ArrowHeads, ModelLine, type LineFlowEdge } from "./ModelLine";
import { usePreviewed } from "./placingPreview";
import { StateNode, type StateFlowNode } from "./StateNode";
import { useDrawing, type Laid } from "./useDrawing";
import { useSize } from "./useSize";
import { ZoomControls } from "./ZoomControls";

const nodeTypes: NodeTypes = { state: StateNode, barrier: BarrierNode };
const edgeTypes: EdgeTypes = { line: ModelLine };

interface Props {
  /** Whose model it is: a run or a document. */
  readonly subject: string;
  readonly tree: ModelTree | undefined;
  /** Where people have placed its states. */
  readonly places?: Places;
  /** What is said where there is no model. */
  readonly nothing: string;
}

export function ModelCanvas({ subject, tree, places = kNoPlaces, nothing }: Props) {
  const frame = useRef<HTMLDivElement>(null);
  const size = useSize(frame);
  const { laid: latest, progress, failed, busy } = useDrawing(subject, tree, places, size);
  const laid = usePreviewed(latest);
  return (
    <section className="canvas" aria-label="Model" aria-busy={busy} ref={frame}>
      <ArrowHeads />
      {laid !== undefined && tree !== undefined ? (
        <ReactFlowProvider>
          <Breadcrumb tree={tree} />
          <CanvasTools tree={tree} detail={laid.detail} />
          <Flow laid={laid} tree={laid.tree} />
          {progress !== undefined && <LayoutProgress progress={progress} laid={laid} />}
        </ReactFlowProvider>
      ) : (
        <Empty text={tree === undefined ? nothing : failed ? "The model could not be drawn." : "Drawing the model…"} />
      )}
    </section>
  );
}

function Empty({ text }: { readonly text: string }) {
  return (
    <div className="canvas-empty">
      <p>{text}</p>
    </div>
  );
}

const Flow = memo(function Flow({ laid, tree }: { readonly laid: Laid; readonly tree: ModelTree }) {
  const nodes = useMemo(
    () =>
      flowNodes(laid.drawing, tree).map(({ drawn, inbound, zIndex }): StateFlowNode | BarrierFlowNode => {
        const place = { id: drawn.path, position: { x: drawn.x, y: drawn.y }, width: drawn.width, height: drawn.height, zIndex, style: kTouchable };
        return drawn.kind === "state"
          ? { ...place, type: "state", data: { drawn } }
          : { ...place, type: "barrier", data: { drawn, inbound } };
      }),
    [laid, tree],
  );
  const edges = useMemo(
    () =>
      flowLines(laid.drawing).map(
        ({ line, source, target, zIndex }): LineFlowEdge => ({ id: line.id, type: "line", source, target, zIndex, data: { line } }),
      ),
    [laid],
  );
  const movedRef = useRef(false);
  const move = () => {
    movedRef.current = true;
  };
  return (
    <ReactFlow
      nodes={nodes}
      edges={edges}
      nodeTypes={nodeTypes}
      edgeTypes={edgeTypes}
      nodesDraggable={false}
      nodesConnectable={false}
      nodesFocusable={false}
      edgesFocusable={false}
      elementsSelectable={false}
      zoomOnDoubleClick={false}
      panOnDrag={[0, 1]}
      minZoom={0.08}
      maxZoom={2.5}
      proOptions={{ hideAttribution: true }}
      onMoveStart={(event) => event !== null && move()}
      onPaneClick={() => view.dispatch({ type: "select", selection: undefined })}
    >
      <Background variant={BackgroundVariant.Dots} gap={22} size={1.2} color="var(--canvas-dots)" />
      <ZoomControls laid={laid} movedRef={movedRef} />
      {laid.drawing.nodes.length > 30 && <MiniMap pannable zoomable position="bottom-right" nodeColor={(node: StateFlowNode | BarrierFlowNode) => (node.data.drawn.depth === 0 ? "var(--minimap-outer)" : "var(--minimap-node)")} maskColor="var(--minimap-mask)" />}
      <Viewport laid={laid} movedRef={movedRef} />
      <FlowView laid={laid} />
    </ReactFlow>
  );
});

/** React Flow disables pointer events of nodes that it neither drags nor selects. */
const kTouchable = { pointerEvents: "all" } as const;
interface ViewportProps {
  readonly laid: Laid;
  /** The user has moved or zoomed the drawing, so it is not fitted again. */
  readonly movedRef: RefObject<boolean>;
}

/** The visible part of the drawing: fits a new drawing and, unless the user has moved it, a resized canvas; moves to the target of a jump; enlarges names when zoomed out. */
function Viewport({ laid, movedRef }: ViewportProps) {
  const { fitView, setViewport } = useReactFlow();
  const width = useStore((s) => s.width);
  const height = useStore((s) => s.height);
  const known = width > 0 && height > 0;
  const zoom = useStore((s) => s.transform[2]);
  const dom = useStore((s) => s.domNode);
  const reveal = useView((v) => v.reveal);
  const selection = useView((v) => v.selection);
  const seenRef = useRef(reveal);

  const show = useEffectEvent((duration: number) => {
    const view = laid.asked ? fitReadable : fit;
    if (known) void setViewport(view(laid.drawing, { width, height }), { duration });
  });

  useEffect(() => {
    movedRef.current = false;
    show(250);
  }, [laid.key, known, movedRef]);

  useEffect(() => {
    if (!movedRef.current) show(0);
  }, [width, height, movedRef]);

  useEffect(() => {
    if (reveal === seenRef.current || selection === undefined) return;
    const id = pathOf(selection);
    if (!laid.drawing.nodes.some((node) => node.path === id)) return;
    seenRef.current = reveal;
    movedRef.current = true;
    const frame = requestAnimationFrame(() => void fitView({ nodes: [{ id }], padding: 1.2, maxZoom: 1.1, duration: 350 }));
    return () => cancelAnimationFrame(frame);
  }, [reveal, selection, laid, fitView, movedRef]);

  useEffect(() => {
    const canvas = dom?.closest<HTMLElement>(".canvas");
    canvas?.setAttribute("data-zoom", zoom < 0.62 ? "far" : "near");
    canvas?.style.setProperty("--least", String(0.5 / zoom));
    canvas?.style.setProperty("--grow", String(Math.min(3, 0.72 / zoom)) satisfies NonNullable<CSSProperties["width"]>);
  }, [zoom, dom]);
  return null;
}
