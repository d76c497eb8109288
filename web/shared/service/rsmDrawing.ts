// A service's RSM as a drawing (Fig. 4.1): states, transitions with their operation, deferrals as dashed links between transitions.
import type { Box, Point } from "../drawing/drawing";
import type { ElkEdge, ElkGraph, LayoutEngine } from "../drawing/elk";
import type { Rsm, RsmTransition } from "../messages/service";

export interface RsmState extends Box {
  readonly name: string;
  /** `state`, the dot before the first state, or the source of transitions that are possible from every state. */
  readonly kind: "state" | "init" | "any";
}

export interface RsmArrow {
  readonly id: string;
  readonly points: readonly Point[];
  readonly label: Box & { readonly text: string; readonly spontaneous: boolean };
}

export interface RsmDrawing {
  readonly states: readonly RsmState[];
  readonly arrows: readonly RsmArrow[];
  readonly start: readonly Point[];
  /** From the transition that takes a call to the one that answers it. */
  readonly deferrals: readonly { readonly id: string; readonly from: Point; readonly to: Point }[];
  readonly width: number;
  readonly height: number;
}

const kInit = "#init";
const kAny = "#any";
const kCharacter = 6.6;
const kMargin = 12;

/** What stands on an arrow: the operation, or the transition's name where none is needed; codes of errors after a slash. */
export function transitionText(transition: RsmTransition): string {
  const trigger = transition.operation ?? transition.id;
  return transition.error === undefined ? trigger : `${trigger} / ${transition.error}`;
}

export function rsmGraph(rsm: Rsm): ElkGraph {
  const any = rsm.transitions.some((t) => t.src === undefined);
  const states = rsm.states.map((s) => ({ id: s.name, width: Math.max(78, s.name.length * 8 + 30), height: 38 }));
  const edges: ElkEdge[] = rsm.transitions.map((t) => ({
    id: t.id,
    sources: [t.src ?? kAny],
    targets: [t.dst],
    labels: [{ id: `${t.id}:label`, text: transitionText(t), width: transitionText(t).length * kCharacter + 14, height: 18 }],
  }));
  if (rsm.init !== undefined) edges.push({ id: kInit, sources: [kInit], targets: [rsm.init] });
  return {
    id: "rsm",
    layoutOptions: {
      "elk.algorithm": "layered",
      "elk.direction": "RIGHT",
      "elk.edgeRouting": "SPLINES",
      "elk.edgeLabels.inline": "true",
      "elk.layered.considerModelOrder.strategy": "NODES_AND_EDGES",
      "elk.layered.cycleBreaking.strategy": "MODEL_ORDER",
      "elk.spacing.nodeNode": "26",
      "elk.layered.spacing.nodeNodeBetweenLayers": "24",
      "elk.spacing.edgeEdge": "14",
      "elk.spacing.edgeNode": "16",
      "elk.padding": "[top=0,left=0,bottom=0,right=0]",
    },
    children: [
      ...(rsm.init === undefined ? [] : [{ id: kInit, width: 10, height: 10 }]),
      ...states,
      ...(any ? [{ id: kAny, width: 74, height: 26 }] : []),
    ],
    edges,
  };
}

export async function drawRsm(engine: LayoutEngine, rsm: Rsm): Promise<RsmDrawing> {
  const graph = await engine(rsmGraph(rsm));
  const boxes = (graph.children ?? []).map((node) => ({
    id: node.id,
    x: (node.x ?? 0) + kMargin,
    y: (node.y ?? 0) + kMargin,
    width: node.width ?? 0,
    height: node.height ?? 0,
  }));
  const edges = new Map((graph.edges ?? []).map((edge) => [edge.id, edge]));
  const arrows = rsm.transitions.map((t): RsmArrow => {
    const label = edges.get(t.id)?.labels?.[0];
    const box = { x: (label?.x ?? 0) + kMargin, y: (label?.y ?? 0) + kMargin, width: label?.width ?? 0, height: label?.height ?? 0 };
    return { id: t.id, points: pointsOf(edges.get(t.id)), label: { ...box, text: transitionText(t), spontaneous: t.operation === undefined } };
  });
  return {
    states: boxes.map(({ id, ...box }) => ({ ...box, name: id === kAny ? "any state" : id, kind: id === kInit ? "init" : id === kAny ? "any" : "state" })),
    arrows,
    start: pointsOf(edges.get(kInit)),
    deferrals: rsm.transitions.flatMap((t) => t.defer.flatMap((answer) => deferral(t.id, answer, arrows))),
    width: (graph.width ?? 0) + 2 * kMargin,
    height: (graph.height ?? 0) + 2 * kMargin,
  };
}

function pointsOf(edge: ElkEdge | undefined): readonly Point[] {
  const section = edge?.sections?.[0];
  if (section === undefined) return [];
  return [section.startPoint, ...(section.bendPoints ?? []), section.endPoint].map((p) => ({ x: p.x + kMargin, y: p.y + kMargin }));
}

function deferral(from: string, to: string, arrows: readonly RsmArrow[]): RsmDrawing["deferrals"] {
  const source = arrows.find((arrow) => arrow.id === from)?.label;
  const target = arrows.find((arrow) => arrow.id === to)?.label;
  if (source === undefined || target === undefined) return [];
  const down = target.y > source.y;
  const middle = (box: Box, below: boolean) => ({ x: box.x + box.width / 2, y: below ? box.y + box.height : box.y });
  return [{ id: `${from}:${to}`, from: middle(source, down), to: middle(target, !down) }];
}

/** The SVG path of an arrow: ELK's splines come as groups of three points of cubic curves. */
export function splinePath(points: readonly Point[]): string {
  const [start, ...rest] = points;
  if (start === undefined) return "";
  const at = (p: Point | undefined) => `${p?.x ?? 0} ${p?.y ?? 0}`;
  const parts = [`M ${at(start)}`];
  for (let i = 0; i < rest.length; i += 3) {
    const left = rest.length - i;
    if (left >= 3) parts.push(`C ${at(rest[i])}, ${at(rest[i + 1])}, ${at(rest[i + 2])}`);
    else if (left === 2) parts.push(`Q ${at(rest[i])}, ${at(rest[i + 1])}`);
    else parts.push(`L ${at(rest[i])}`);
  }
  return parts.join(" ");
}
