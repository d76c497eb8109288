// Automatic layout of a nested model: every composite is laid out alone, from the inside out, in several arrangements; the one
// that fills a landscape frame best is taken. No line crosses more than one border (constraint after Def. 3.8), so that suffices.
import type { Node, State } from "../model/model";
import { compositeGraph, inletOf, linesOf, type Arrangement, type ChildBox } from "./compositeGraph";
import type { Box, DrawnLine, DrawnNode, DrawnPort, Drawing, Point, Side } from "./drawing";
import type { ElkEdge, ElkGraph, LayoutEngine } from "./elk";
import { barrierSize, conditionText, drawnLines, headSize, leafBoxes, portInset, type Detail, type Size } from "./measure";

export interface LayoutRequest {
  /** The state whose inside fills the canvas, and its path. */
  readonly state: State;
  readonly path: string;
  /** Paths of composites drawn without their children. */
  readonly collapsed: ReadonlySet<string>;
  readonly detail: Detail;
  /** Width by height of the canvas. */
  readonly aspect: number;
}

/** A laid out subtree; coordinates are relative to its top left corner. */
interface Block {
  readonly size: Size;
  readonly ports: readonly Box[];
  readonly nodes: readonly DrawnNode[];
  readonly lines: readonly DrawnLine[];
}

/** The request with what was laid out for it: a state is needed in each arrangement of all that it lies in, so without this
 *  the work would double with every level. */
interface Job extends LayoutRequest {
  readonly known: Map<string, Promise<Block>>;
}

const kMargin = 24;
/** From so many children on, one direction is enough to try. */
const kMany = 40;

export async function layoutModel(engine: LayoutEngine, request: LayoutRequest): Promise<Drawing> {
  const block = await layoutNode(engine, { ...request, known: new Map() }, request.state, request.path, "EAST", 0);
  const reach = Math.max(0, ...block.ports.map((port) => port.x + port.width - block.size.width));
  const shifted = shift(block, { x: kMargin, y: kMargin });
  const stub = 40;
  return {
    nodes: shifted.nodes,
    lines: shifted.lines,
    width: block.size.width + reach + stub + 2 * kMargin,
    height: block.size.height + 2 * kMargin,
  };
}

function layoutNode(engine: LayoutEngine, job: Job, node: Node, path: string, side: Side, depth: number): Promise<Block> {
  const key = `${side} ${path}`;
  const block = job.known.get(key) ?? layoutOnce(engine, job, node, path, side, depth);
  job.known.set(key, block);
  return block;
}

async function layoutOnce(engine: LayoutEngine, request: Job, node: Node, path: string, side: Side, depth: number): Promise<Block> {
  if (node.kind === "barrier") return leaf(request, node, path, side, depth);
  const open = node.children.length > 0 && !request.collapsed.has(path);
  if (!open) return leaf(request, node, path, side, depth);
  const candidates: Block[] = [];
  for (const direction of node.children.length > kMany ? (["RIGHT"] as const) : (["RIGHT", "DOWN"] as const)) {
    const inner: Side = direction === "RIGHT" ? "EAST" : "SOUTH";
    const children = new Map<string, Block>();
    for (const child of node.children) {
      const childPath = `${path}/${child.name}`;
      children.set(childPath, await layoutNode(engine, request, child, childPath, inner, depth + 1));
    }
    for (const arrangement of arrangements(direction, node.children.length, request.aspect)) {
      const block = await arrange(engine, request, node, path, side, depth, arrangement, children).catch(() => undefined);
      if (block !== undefined) candidates.push(block);
    }
  }
  return best(candidates, request.aspect);
}

function arrangements(direction: Arrangement["direction"], children: number, aspect: number): readonly Arrangement[] {
  const plain: Arrangement = { direction, wrap: false, aspect };
  if (children < 4) return [plain];
  if (children > kMany) return [plain, { direction, wrap: true, aspect }];
  return [plain, { direction, wrap: true, aspect }, { direction, wrap: true, aspect: aspect * 1.6 }];
}

/** How far the eye has to travel along a line, on average: long ways around cost readability. */
function travel(lines: readonly DrawnLine[]): number {
  const length = (points: readonly Point[]) =>
    points.reduce((sum, p, i) => sum + Math.hypot(p.x - (points[i - 1] ?? p).x, p.y - (points[i - 1] ?? p).y), 0);
  const weight = (line: DrawnLine) => (line.kind === "exit" ? 0.4 : 1);
  return lines.length === 0 ? 0 : lines.reduce((sum, line) => sum + weight(line) * length(line.points), 0) / lines.length;
}

/** The block that can be shown largest in a frame of this aspect, with some weight on its area and on the length of its lines. */
function best(blocks: readonly Block[], aspect: number): Block {
  const cost = ({ size, ports, lines }: Block) => {
    const width = size.width + Math.max(0, ...ports.map((port) => port.x + port.width - size.width));
    return Math.max(width / aspect, size.height) + 0.35 * Math.sqrt((width * size.height) / aspect) + 0.6 * travel(lines);
  };
  const first = blocks[0];
  if (first === undefined) throw new Error("no arrangement");
  return blocks.reduce((found, block) => (cost(block) < cost(found) ? block : found), first);
}

async function arrange(
  engine: LayoutEngine,
  request: LayoutRequest,
  state: State,
  path: string,
  side: Side,
  depth: number,
  arrangement: Arrangement,
  blocks: ReadonlyMap<string, Block>,
): Promise<Block> {
  const boxes = state.children.map((node): ChildBox => {
    const childPath = `${path}/${node.name}`;
    const block = blocks.get(childPath);
    return { node, path: childPath, size: block?.size ?? { width: 0, height: 0 }, ports: block?.ports ?? [] };
  });
  const graph = compositeGraph(state, path, boxes, side, arrangement, request.detail);
  const answer = (await engine(graph)).children?.[0];
  if (answer === undefined) throw new Error(`no layout for ${path}`);
  const size = { width: answer.width ?? 0, height: answer.height ?? 0 };
  const ports = state.ports.map((port) => frameBox(answer, `${path}.${port.name}`, side, size));
  const placed = (answer.children ?? []).flatMap((child) => {
    const block = blocks.get(child.id);
    return block === undefined ? [] : [shift(block, { x: child.x ?? 0, y: child.y ?? 0 })];
  });
  const own = drawState(request, state, path, side, depth, size, ports, true);
  return {
    size,
    ports,
    nodes: [own, ...placed.flatMap((block) => block.nodes)],
    lines: [...levelLines(request, state, path, depth, answer), ...placed.flatMap((block) => block.lines)],
  };
}

function frameBox(graph: ElkGraph, id: string, side: Side, size: Size): Box {
  const found = graph.ports?.find((port) => port.id === id);
  const box = { x: found?.x ?? 0, y: found?.y ?? 0, width: found?.width ?? 0, height: found?.height ?? 0 };
  return side === "EAST" ? { ...box, x: size.width - portInset } : { ...box, y: size.height - portInset };
}

function levelLines(
  request: LayoutRequest,
  state: State,
  path: string,
  depth: number,
  graph: ElkGraph,
): readonly DrawnLine[] {
  const head = headSize(state, request.detail).height;
  const edges = new Map((graph.edges ?? []).map((edge) => [edge.id, edge]));
  return linesOf(state, path).flatMap((line): DrawnLine[] => {
    const edge = edges.get(line.id);
    const points = edge === undefined && line.kind === "first" ? firstArrow(line.to, graph) : edgePoints(edge);
    if (points.length < 2) return [];
    return [{ ...line, depth: depth + 1, points: line.kind === "first" ? beneath(points, head) : points }];
  });
}

const kFirstArrow = 20;

/** The arrow to `first` where ELK does not route it: from the border if nothing stands between, else from a dot before the child. */
function firstArrow(to: string, graph: ElkGraph): readonly Point[] {
  const child = graph.children?.find((entry) => entry.id === to);
  const inlet = child?.ports?.find((port) => port.id === inletOf(to));
  if (child === undefined || inlet === undefined) return [];
  const end = { x: (child.x ?? 0) + (inlet.x ?? 0), y: (child.y ?? 0) + (inlet.y ?? 0) };
  if (inlet.y === 0) return [{ x: end.x, y: end.y - kFirstArrow }, end];
  const blocked = graph.children?.some((other) => {
    const top = other.y ?? 0;
    return other !== child && (other.x ?? 0) < end.x && top - kFirstArrow < end.y && end.y < top + (other.height ?? 0) + kFirstArrow;
  });
  return [{ x: blocked === true ? end.x - kFirstArrow : 0, y: end.y }, end];
}

/** The arrow to `first` that comes from above begins beneath the text section, where the children's area begins. */
function beneath(points: readonly Point[], head: number): readonly Point[] {
  const [start, next, ...rest] = points;
  if (start === undefined || next === undefined || start.x !== next.x || start.y >= head) return points;
  return [{ x: start.x, y: Math.min(head, next.y) }, next, ...rest];
}

function edgePoints(edge: ElkEdge | undefined): readonly Point[] {
  const section = edge?.sections?.[0];
  if (section === undefined) return [];
  return [section.startPoint, ...(section.bendPoints ?? []), section.endPoint];
}

function leaf(request: LayoutRequest, node: Node, path: string, side: Side, depth: number): Block {
  if (node.kind === "barrier") {
    const size = barrierSize(side);
    const drawn: DrawnNode = {
      kind: "barrier", path, name: node.name, depth, x: 0, y: 0, ...size, composite: false, open: false, lines: [], ports: [], side,
    };
    return { size, ports: [], nodes: [drawn], lines: [] };
  }
  const { size, ports } = leafBoxes(node, side, request.detail);
  return { size, ports, nodes: [drawState(request, node, path, side, depth, size, ports, false)], lines: [] };
}

function drawState(
  request: LayoutRequest,
  state: State,
  path: string,
  side: Side,
  depth: number,
  size: Size,
  boxes: readonly Box[],
  open: boolean,
): DrawnNode {
  const ports = state.ports.flatMap((port, i): DrawnPort[] => {
    const box = boxes[i];
    if (box === undefined) return [];
    const condition = request.detail === "slim" ? "" : conditionText(port);
    return [{ ...box, address: `${path}.${port.name}`, name: port.name, condition, when: port.when, exits: port.to === undefined }];
  });
  const badge = state.link !== undefined ? `link ${state.link}` : state.oracle;
  return {
    kind: "state", path, name: state.name, depth, x: 0, y: 0, ...size, composite: state.children.length > 0, open,
    lines: drawnLines(state, request.detail), ports, side, ...(badge === undefined ? {} : { badge }),
  };
}

function shift(block: Block, by: Point): Block {
  const move = <T extends Point>(item: T): T => ({ ...item, x: item.x + by.x, y: item.y + by.y });
  return {
    ...block,
    nodes: block.nodes.map((node) => ({ ...move(node), ports: node.ports.map(move) })),
    lines: block.lines.map((line) => ({ ...line, points: line.points.map(move) })),
  };
}

