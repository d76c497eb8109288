// Automatic layout of a nested model: every composite is laid out alone, from the inside out, in several arrangements; the one
// that fills a landscape frame best is taken. No line crosses more than one border (constraint after Def. 3.8), so that suffices.
import { childPath, portAddress, type Node, type State } from "../model/model";
import { shift, rebase, type Block } from "./block";
import { compositeGraph, inletOf, linesOf, type Arrangement, type ChildBox } from "./compositeGraph";
import type { Box, DrawnLine, Drawing, Point, Side } from "./drawing";
import { drawState, leaf } from "./drawnState";
import type { ElkEdge, ElkGraph, LayoutEngine } from "./elk";
import { layoutCache, type LayoutCache } from "./layoutCache";
import { headSize, portInset, type Detail, type Size } from "./measure";
import { contentOrigin, placedLevel, type PlacedChild } from "./placed";
import { kNoPlaces, placeOfChild, type Place, type Places } from "./places";

export interface LayoutRequest {
  /** The state whose inside fills the canvas, and its path. */
  readonly state: State;
  readonly path: string;
  /** Paths of composites drawn without their children. */
  readonly collapsed: ReadonlySet<string>;
  readonly detail: Detail;
  /** Where a person has placed states and barriers: they stay there. */
  readonly places?: Places;
  /** Width by height of the canvas. */
  readonly aspect: number;
  /** Aborted when the drawing is no longer wanted: its promise is rejected with the signal's reason. */
  readonly signal?: AbortSignal;
  /** How many composites are laid out, of how many. */
  readonly onProgress?: (done: number, of: number) => void;
}

/** The request with what is being laid out for it: a state is needed in each arrangement of all that it lies in, so without
 *  this the work would double with every level. */
interface Job extends LayoutRequest {
  readonly places: Places;
  readonly begun: Map<string, Promise<Block>>;
  readonly memory: LayoutCache;
  /** A composite is laid out. */
  readonly done: () => void;
}

const kMargin = 24;
/** From so many children on, one direction is enough to try. */
const kMany = 40;
/** With more composites, so large that it is read as a map first, a drawing wraps rows on so many of its levels alone. */
const kThorough = 40;
const kUpper = 2;

export async function layoutModel(engine: LayoutEngine, request: LayoutRequest, memory = layoutCache()): Promise<Drawing> {
  let count = 0;
  const job: Job = { ...request, places: request.places ?? kNoPlaces, begun: new Map(), memory, done: () => request.onProgress?.(++count, of) };
  // Independent of the cache: the same request gives the same drawing.
  const levels = looksOf(job, Infinity, () => false).size <= kThorough ? Infinity : kUpper;
  const of = looksOf(job, levels, (look) => memory.find(look) !== undefined).size;
  request.onProgress?.(0, of);
  const block = await layoutNode(engine, job, request.state, request.path, "EAST", 0, levels);
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

const isOpen = (request: LayoutRequest, node: Node, path: string): node is State =>
  node.kind === "state" && node.children.length > 0 && !request.collapsed.has(path);

/** The direction of a level in which somebody has placed children is that of the first of them, so that the others stay as they are. */
function directionsOf(job: Job, state: State): readonly Arrangement["direction"][] {
  const place = placesIn(job, state).find((each) => each !== undefined);
  if (place !== undefined) return [place.side === "EAST" ? "RIGHT" : "DOWN"];
  return state.children.length > kMany ? ["RIGHT"] : ["RIGHT", "DOWN"];
}

const sideIn = (direction: Arrangement["direction"]): Side => (direction === "RIGHT" ? "EAST" : "SOUTH");

/** The places of the children of a state, in their order. */
const placesIn = (job: Job, state: State): readonly (Place | undefined)[] => state.children.map((child) => placeOfChild(job.places, state, child));

const sideOf = (job: Job, state: State, child: Node, direction: Arrangement["direction"]): Side => placeOfChild(job.places, state, child)?.side ?? sideIn(direction);

/** Of how many levels beneath it rows are wrapped, when they are of so many from a state's own down. */
const beneathIt = (levels: number): number => Math.max(0, levels - 1);

/** The composites that have to be laid out, each for each border that its ports may stand on, without those that are known and what only they need. */
function looksOf(job: Job, levels: number, known: (look: string) => boolean): ReadonlySet<string> {
  const found = new Set<string>();
  const visit = (node: Node, path: string, side: Side, levels: number): void => {
    if (!isOpen(job, node, path)) return;
    const look = job.memory.look(node, path, side, levels, job);
    if (found.has(look) || known(look)) return;
    found.add(look);
    for (const direction of directionsOf(job, node))
      for (const child of node.children) visit(child, childPath(path, child), sideOf(job, node, child, direction), beneathIt(levels));
  };
  visit(job.state, job.path, "EAST", levels);
  return found;
}

async function layoutNode(engine: LayoutEngine, job: Job, node: Node, path: string, side: Side, depth: number, levels: number): Promise<Block> {
  if (!isOpen(job, node, path)) return leaf(job, node, path, side, depth);
  const look = job.memory.look(node, path, side, levels, job);
  const known = job.memory.find(look) ?? (await (job.begun.get(look) ?? begin(engine, job, node, path, side, depth, levels, look)));
  return rebase(known, path, depth);
}

function begin(engine: LayoutEngine, job: Job, state: State, path: string, side: Side, depth: number, levels: number, look: string): Promise<Block> {
  const block = layoutOnce(engine, job, state, path, side, depth, levels).then((laid) => {
    job.memory.keep(look, laid);
    job.done();
    return laid;
  });
  job.begun.set(look, block);
  return block;
}

async function layoutOnce(engine: LayoutEngine, job: Job, state: State, path: string, side: Side, depth: number, levels: number): Promise<Block> {
  const failures: unknown[] = [];
  const places = placesIn(job, state);
  const candidates = await Promise.all(
    directionsOf(job, state).map(async (direction) => {
      const laid = state.children.map(async (child) => {
        const at = childPath(path, child);
        return [at, await layoutNode(engine, job, child, at, sideOf(job, state, child, direction), depth + 1, beneathIt(levels))] as const;
      });
      const children = new Map(await Promise.all(laid));
      if (places.every((place) => place !== undefined)) return [placed(job, state, path, side, depth, children, undefined)];
      // An arrangement may fail in ELK; an abort is passed on.
      const attempt = (arrangement: Arrangement) =>
        arrange(engine, job, state, path, side, depth, arrangement, children).catch((error: unknown) => {
          job.signal?.throwIfAborted();
          failures.push(error);
          return undefined;
        });
      const plain = await attempt({ direction, wrap: false, aspect: job.aspect });
      const isEnough = levels === 0 || (plain !== undefined && !tooLong(plain.size, direction, job.aspect));
      const blocks = isEnough ? [plain] : [plain, ...(await Promise.all(wrapped(direction, state.children.length, job.aspect).map(attempt)))];
      if (places.every((place) => place === undefined)) return blocks;
      const [first, ...others] = blocks.filter((block) => block !== undefined);
      return first === undefined ? [] : [placed(job, state, path, side, depth, children, best(first, others, job.aspect))];
    }),
  );
  const [first, ...others] = candidates.flat().filter((block) => block !== undefined);
  if (first === undefined) throw failures[0];
  return best(first, others, job.aspect);
}

/** Whether rows in this direction stick out of a frame of this aspect, so that it may help to wrap them. */
function tooLong({ width, height }: Size, direction: Arrangement["direction"], aspect: number): boolean {
  return direction === "RIGHT" ? width > aspect * height : width < aspect * height;
}

function wrapped(direction: Arrangement["direction"], children: number, aspect: number): readonly Arrangement[] {
  if (children < 4) return [];
  const once: Arrangement = { direction, wrap: true, aspect };
  return children > kMany ? [once] : [once, { ...once, aspect: aspect * 1.6 }];
}

/** Average length of the lines: long detours are hard to read. */
function travel(lines: readonly DrawnLine[]): number {
  const length = (points: readonly Point[]) =>
    points.reduce((sum, p, i) => sum + Math.hypot(p.x - (points[i - 1] ?? p).x, p.y - (points[i - 1] ?? p).y), 0);
  const weight = (line: DrawnLine) => (line.kind === "exit" ? 0.4 : 1);
  return lines.length === 0 ? 0 : lines.reduce((sum, line) => sum + weight(line) * length(line.points), 0) / lines.length;
}

/** The block that can be shown largest in a frame of this aspect, with some weight on its area and on the length of its lines. */
function best(first: Block, others: readonly Block[], aspect: number): Block {
  const cost = ({ size, ports, lines }: Block) => {
    const width = size.width + Math.max(0, ...ports.map((port) => port.x + port.width - size.width));
    return Math.max(width / aspect, size.height) + 0.35 * Math.sqrt((width * size.height) / aspect) + 0.6 * travel(lines);
  };
  return others.reduce((found, block) => (cost(block) < cost(found) ? block : found), first);
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
    const at = childPath(path, node);
    const block = blocks.get(at);
    return { node, path: at, size: block?.size ?? { width: 0, height: 0 }, ports: block?.ports ?? [] };
  });
  request.signal?.throwIfAborted();
  const graph = compositeGraph(state, path, boxes, side, arrangement, request.detail);
  const answer = (await engine(graph)).children?.[0];
  if (answer === undefined) throw new Error(`no layout for ${path}`);
  const size = { width: answer.width ?? 0, height: answer.height ?? 0 };
  const ports = state.ports.map((port) => frameBox(answer, portAddress(path, port), side, size));
  const inner = (answer.children ?? []).flatMap((child) => {
    const block = blocks.get(child.id);
    return block === undefined ? [] : [shift(block, { x: child.x ?? 0, y: child.y ?? 0 })];
  });
  const own = { ...drawState(request, state, path, side, depth, size, ports, true), content: contentOrigin(state, request.detail) };
  return {
    size,
    ports,
    nodes: [own, ...inner.flatMap((block) => block.nodes)],
    lines: [...levelLines(request, state, path, depth, answer), ...inner.flatMap((block) => block.lines)],
  };
}

/** A level in which somebody has placed children; `automatic`: as it is without. */
function placed(job: Job, state: State, path: string, side: Side, depth: number, blocks: ReadonlyMap<string, Block>, automatic: Block | undefined): Block {
  const origin = contentOrigin(state, job.detail);
  const inContent = ({ x, y }: Point): Point => ({ x: x - origin.x, y: y - origin.y });
  const nodes = new Map(automatic?.nodes.filter((node) => node.depth === depth + 1).map((node) => [node.path, node]));
  const children = state.children.flatMap((node): PlacedChild[] => {
    const at = childPath(path, node);
    const [block, place] = [blocks.get(at), placeOfChild(job.places, state, node)];
    const root = block?.nodes[0];
    if (block === undefined || root === undefined) return [];
    return [{ node, path: at, size: block.size, ports: block.ports, side: root.side, pinned: place !== undefined, at: place ?? inContent(nodes.get(at) ?? origin) }];
  });
  const ways = new Map(automatic?.lines.filter((line) => line.depth === depth + 1).map((line) => [line.id, line.points.map(inContent)]));
  const level = placedLevel(state, path, side, job.detail, children, ways);
  const own = { ...drawState(job, state, path, side, depth, level.size, level.ports, true), content: level.content };
  const inner = children.flatMap((child) => {
    const [block, at] = [blocks.get(child.path), level.at.get(child.path)];
    return block === undefined || at === undefined ? [] : [shift(block, at)];
  });
  const lines = level.lines.map((line): DrawnLine => ({ ...line, depth: depth + 1 }));
  return { size: level.size, ports: level.ports, nodes: [own, ...inner.flatMap((block) => block.nodes)], lines: [...lines, ...inner.flatMap((block) => block.lines)] };
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
