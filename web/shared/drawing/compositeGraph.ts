// One composite state as an ELK graph: its children as boxes with fixed ports, its own ports as ports of the frame.
import { exitReferences } from "../model/exitReferences";
import { childPath, keyOf, portAddress, type Node, type State } from "../model/model";
import type { Box, LineKind, Side } from "./drawing";
import type { ElkEdge, ElkGraph, ElkShape } from "./elk";
import { headSize, portInset, portSize, type Detail, type Size } from "./measure";

/** A child as the level above sees it: a box whose ports have places. */
export interface ChildBox {
  readonly node: Node;
  readonly path: string;
  readonly size: Size;
  readonly ports: readonly Box[];
}

/** How a composite's children are arranged. */
export interface Arrangement {
  readonly direction: "RIGHT" | "DOWN";
  readonly wrap: boolean;
  readonly aspect: number;
}

/** What a line means, kept beside the graph because ELK knows edges only. */
export interface LineSpec {
  readonly id: string;
  readonly kind: LineKind;
  readonly from: string;
  readonly to: string;
}

export const inletOf = (path: string): string => `${path}#in`;
export const firstOf = (path: string): string => `${path}#first`;

/** Transitions, forks, the arrow to `first` and exits of one composite. */
export function linesOf(state: State, path: string): readonly LineSpec[] {
  const names = new Set(state.children.map((child) => child.name));
  const lines: LineSpec[] = [];
  if (state.first !== undefined && names.has(state.first)) {
    lines.push({ id: `${path}→first`, kind: "first", from: path, to: `${path}/${state.first}` });
  }
  for (const child of state.children) {
    const source = childPath(path, child);
    if (child.kind === "barrier") {
      for (const to of child.to) lines.push({ id: `${source}→${to}`, kind: "fork", from: source, to: `${path}/${to}` });
      continue;
    }
    for (const port of child.ports) {
      if (port.to === undefined || !names.has(port.to)) continue;
      const from = portAddress(source, port);
      lines.push({ id: `${from}→${port.to}`, kind: "transition", from, to: `${path}/${port.to}` });
    }
  }
  for (const port of state.ports) {
    for (const { child, port: exit } of port.when === undefined ? [] : exitReferences(port.when)) {
      const found = state.children.find((entry) => entry.name === child);
      if (found?.kind !== "state" || !found.ports.some((entry) => entry.name === exit)) continue;
      const from = `${path}/${child}.${exit}`;
      lines.push({ id: `${from}→${keyOf(port)}`, kind: "exit", from, to: portAddress(path, port) });
    }
  }
  return lines;
}

function childShape(child: ChildBox, direction: Arrangement["direction"]): ElkGraph {
  const outlet = direction === "RIGHT" ? "EAST" : "SOUTH";
  const inlet = direction === "RIGHT" ? { x: 0, y: Math.min(16, child.size.height / 2) } : { x: child.size.width / 2, y: 0 };
  const ports: ElkShape[] = [
    { id: inletOf(child.path), width: 0, height: 0, ...inlet, layoutOptions: { "elk.port.side": direction === "RIGHT" ? "WEST" : "NORTH" } },
  ];
  if (child.node.kind === "state") {
    child.node.ports.forEach((port, i) => {
      const box = child.ports[i];
      if (box === undefined) return;
      const layoutOptions = { "elk.port.side": outlet, "elk.port.borderOffset": String(-portInset) };
      ports.push({ id: portAddress(child.path, port), ...box, layoutOptions });
    });
  } else {
    const outletPlace =
      direction === "RIGHT" ? { x: child.size.width, y: child.size.height / 2 } : { x: child.size.width / 2, y: child.size.height };
    ports.push({ id: `${child.path}#out`, width: 0, height: 0, ...outletPlace, layoutOptions: { "elk.port.side": outlet } });
  }
  return { id: child.path, ...child.size, ports, layoutOptions: { "elk.portConstraints": "FIXED_POS" } };
}

function frameSource(line: LineSpec): string {
  if (line.kind === "first") return firstOf(line.from);
  return line.kind === "fork" ? `${line.from}#out` : line.from;
}

/** The graph of one composite in one arrangement. `side` is the border on which the composite's own ports stand. */
export function compositeGraph(
  state: State,
  path: string,
  children: readonly ChildBox[],
  side: Side,
  arrangement: Arrangement,
  detail: Detail,
): ElkGraph {
  const { direction, wrap, aspect } = arrangement;
  const head = headSize(state, detail);
  // Declaration order is the order of evaluation, so it is kept: ELK counts clockwise.
  const clockwise = (i: number) => (side === "EAST" ? i : state.ports.length - 1 - i);
  const frame: ElkShape[] = state.ports.map((port, i) => ({
    id: portAddress(path, port),
    ...portSize(port, detail),
    layoutOptions: { "elk.port.side": side, "elk.port.index": String(clockwise(i)), "elk.port.borderOffset": String(-portInset) },
  }));
  const first: ElkShape = {
    id: firstOf(path),
    width: 0,
    height: 0,
    layoutOptions: { "elk.port.side": direction === "RIGHT" ? "WEST" : "NORTH", "elk.port.index": "0" },
  };
  // Where rows are wrapped, an edge from the frame would cost a column of its own: layout.ts draws that arrow.
  const routed = linesOf(state, path).filter((line) => !(wrap && line.kind === "first"));
  const edges: ElkEdge[] = routed.map((line) => ({
    id: line.id,
    sources: [frameSource(line)],
    targets: [line.kind === "exit" ? line.to : inletOf(line.to)],
  }));
  return {
    id: "drawing",
    layoutOptions: { "elk.algorithm": "layered", "elk.padding": "[top=0,left=0,bottom=0,right=0]" },
    children: [
      {
        id: path,
        ports: wrap ? frame : [first, ...frame],
        children: children.map((child) => childShape(child, direction)),
        edges,
        layoutOptions: {
          "elk.algorithm": "layered",
          "elk.direction": direction,
          "elk.edgeRouting": "ORTHOGONAL",
          "elk.portConstraints": "FIXED_ORDER",
          "elk.aspectRatio": String(aspect),
          "elk.layered.wrapping.strategy": wrap ? "MULTI_EDGE" : "OFF",
          "elk.layered.wrapping.additionalEdgeSpacing": "8",
          "elk.layered.mergeEdges": "true",
          "elk.layered.considerModelOrder.strategy": "PREFER_NODES",
          "elk.layered.cycleBreaking.strategy": "MODEL_ORDER",
          "elk.layered.nodePlacement.strategy": "NETWORK_SIMPLEX",
          "elk.layered.nodePlacement.favorStraightEdges": "true",
          "elk.spacing.nodeNode": "18",
          "elk.spacing.edgeNode": "12",
          "elk.spacing.edgeEdge": "9",
          "elk.spacing.portPort": "10",
          "elk.spacing.portsSurrounding": "[top=12,left=12,bottom=12,right=12]",
          "elk.layered.spacing.nodeNodeBetweenLayers": "24",
          "elk.layered.spacing.edgeNodeBetweenLayers": "9",
          "elk.layered.spacing.edgeEdgeBetweenLayers": "7",
          "elk.nodeSize.constraints": "[PORTS, MINIMUM_SIZE]",
          "elk.nodeSize.minimum": `(${head.width + portInset}, ${head.height + 60})`,
          "elk.padding": `[top=${head.height + 16},left=18,bottom=${side === "SOUTH" ? 14 + portInset : 18},right=${side === "EAST" ? 14 + portInset : 18}]`,
        },
      },
    ],
  };
}
