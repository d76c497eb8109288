// The overview of a drawing of elements in a corner, while it is needed.
import { MiniMap, useStore } from "@xyflow/react";
import type { Drawing } from "../../shared/drawing/drawing";
import { needsMiniMap } from "../../shared/drawing/miniMap";
import type { BarrierFlowNode } from "./BarrierNode";
import type { StateFlowNode } from "./StateNode";

/** A smaller drawing is not lost from view. */
const kLeastNodes = 30;

const colour = (node: StateFlowNode | BarrierFlowNode): string => (node.data.drawn.depth === 0 ? "var(--minimap-outer)" : "var(--minimap-node)");

export function FlowMiniMap({ drawing }: { readonly drawing: Drawing }) {
  const isNeeded = useStore(({ width, height, transform: [x, y, zoom] }) => drawing.nodes.length > kLeastNodes && needsMiniMap({ x, y, zoom }, drawing, { width, height }));
  return isNeeded ? <MiniMap pannable zoomable position="bottom-right" nodeColor={colour} maskColor="var(--minimap-mask)" /> : null;
}
