// The canvas of a small drawing: an element for each node and line, with zoom and pan by React Flow.
import { Background, BackgroundVariant, ReactFlow, type NodeTypes, type EdgeTypes } from "@xyflow/react";
import { memo, useMemo, type RefObject } from "react";
import { flowLines, flowNodes } from "../../shared/drawing/flow";
import { kZoomLimits } from "../../shared/drawing/movement";
import { view } from "../client";
import { BarrierNode, type BarrierFlowNode } from "./BarrierNode";
import { FlowMiniMap } from "./FlowMiniMap";
import { FlowView } from "./FlowView";
import { takeOver } from "./moved";
import { ArrowHeads, ModelLine, type LineFlowEdge } from "./ModelLine";
import { StateNode, type StateFlowNode } from "./StateNode";
import type { Laid } from "./useDrawing";

const nodeTypes: NodeTypes = { state: StateNode, barrier: BarrierNode };
const edgeTypes: EdgeTypes = { line: ModelLine };

/** React Flow disables pointer events of nodes that it neither drags nor selects. */
const kTouchable = { pointerEvents: "all" } as const;

interface Props {
  readonly laid: Laid;
  /** Whether the user has moved or zoomed the drawing. */
  readonly movedRef: RefObject<boolean>;
}

export const Flow = memo(function Flow({ laid, movedRef }: Props) {
  const nodes = useMemo(
    () =>
      flowNodes(laid.drawing, laid.tree).map(({ drawn, inbound, zIndex }): StateFlowNode | BarrierFlowNode => {
        const place = { id: drawn.path, position: { x: drawn.x, y: drawn.y }, width: drawn.width, height: drawn.height, zIndex, style: kTouchable };
        return drawn.kind === "state"
          ? { ...place, type: "state", data: { drawn } }
          : { ...place, type: "barrier", data: { drawn, inbound } };
      }),
    [laid],
  );
  const edges = useMemo(
    () =>
      flowLines(laid.drawing).map(
        ({ line, source, target, zIndex }): LineFlowEdge => ({ id: line.id, type: "line", source, target, zIndex, data: { line } }),
      ),
    [laid],
  );
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
      maxZoom={kZoomLimits.most}
      proOptions={{ hideAttribution: true }}
      onMoveStart={(event) => event !== null && takeOver(movedRef)}
      onPaneClick={() => view.dispatch({ type: "select", selection: undefined })}
    >
      <Background variant={BackgroundVariant.Dots} gap={22} size={1.2} color="var(--canvas-dots)" />
      <FlowMiniMap drawing={laid.drawing} />
      <FlowView laid={laid} />
      <ArrowHeads />
    </ReactFlow>
  );
});
