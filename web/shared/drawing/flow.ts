// The drawing as nodes and edges of the canvas library; deeper levels lie above, lines lie between their frame and its children.
import { inboundPorts, ownerOf, type ModelTree } from "../model/modelTree";
import type { DrawnLine, DrawnNode, Drawing } from "./drawing";
import { stubs } from "./stubs";

export interface FlowNode {
  readonly drawn: DrawnNode;
  readonly inbound: readonly string[];
  readonly zIndex: number;
}

export interface FlowLine {
  readonly line: DrawnLine;
  /** Paths of the nodes at its ends; a line to nowhere ends where it starts. */
  readonly source: string;
  readonly target: string;
  readonly zIndex: number;
}

export function flowNodes(drawing: Drawing, tree: ModelTree): readonly FlowNode[] {
  return drawing.nodes.map((drawn) => ({
    drawn,
    inbound: drawn.kind === "barrier" ? inboundPorts(tree, drawn.path) : [],
    zIndex: drawn.depth * 2,
  }));
}

export function flowLines(drawing: Drawing): readonly FlowLine[] {
  return [...drawing.lines, ...stubs(drawing)].map((line) => ({
    line,
    source: ownerOf(line.from),
    target: line.to === undefined ? ownerOf(line.from) : ownerOf(line.to),
    zIndex: line.depth * 2 - 1,
  }));
}
