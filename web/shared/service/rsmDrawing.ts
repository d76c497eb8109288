// A service's RSM as a drawing (Fig. 4.1): states, transitions with their operation, deferrals as dashed links between transitions.
import type { Box, Point } from "../drawing/drawing";
import type { ElkEdge, ElkGraph, LayoutEngine } from "../drawing/elk";
import type { Rsm, RsmTransition } from "../../generated/messages";

export interface RsmState extends Box {
  readonly name: string;
  /** `state`, the dot before the first state, or the source of transitions that are possible from every state. */
  readonly kind: "state" | "init" | "any";
}

export interface RsmArrow {
  readonly id: string;
  /** The transitions that it stands for: several where they differ in their operation only. */
  readonly transitions: readonly string[];
  readonly points: readonly Point[];
  readonly label: Box & { readonly text: string; readonly lines: readonly string[]; readonly spontaneous: boolean };
}

export interface RsmDrawing {
  readonly states: readonly RsmState[];
  readonly arrows: readonly RsmArrow[];
  readonly start: readonly Point[];
  /** From the transition that takes a call to the one that answers it. */
  readonly deferrals: readonly { readonly id: string; readonly path: string }[];
  readonly width: number;
  readonly height: number;
}

const kInit = "#init";
const kAny = "#any";
const kCharacter = 6.6;
const kMargin = 30;
/** How far an arc beside labels is from them: more for those that are farther apart, so that the arcs of one call lie in each other. */
const kArc = 26;
const kArcGrowth = 0.25;
/** Labels that are farther apart than this [px] have another one between them. */
const kFar = 44;
/** A line of a label is not longer, unless by one name. */
const kLine = 22;
/** From line to line of a label [px]. */
export const kRsmLine = 15;

/** The label of an arrow: the operation, or the name of a spontaneous transition; codes of errors after a slash. */
export function transitionText(transition: RsmTransition): string {
  const trigger = transition.operation ?? transition.id;
  return transition.error === undefined ? trigger : `${trigger} / ${transition.error}`;
}

interface Group {
  readonly id: string;
  readonly src: string;
  readonly dst: string;
  readonly transitions: readonly RsmTransition[];
  readonly text: string;
}

/** Operations that lead from the same state, or from all, to the same one, and are answered alike, share an arrow, unless an error tells them apart. */
function groups(rsm: Rsm): readonly Group[] {
  const transitions = rsm.transitions ?? [];
  const answers = new Set(transitions.flatMap((t) => t.defer ?? []));
  const found = new Map<string, RsmTransition[]>();
  for (const t of transitions) {
    const plain = t.error === undefined && t.operation !== undefined && !answers.has(t.id);
    const key = plain ? `${t.src ?? kAny} to ${t.dst}, ${(t.defer ?? []).join(" ")}` : t.id;
    found.set(key, [...(found.get(key) ?? []), t]);
  }
  return [...found.values()].flatMap((group) => {
    const first = group[0];
    if (first === undefined) return [];
    const text = group.map(transitionText).join(", ");
    return [{ id: first.id, src: first.src ?? kAny, dst: first.dst, transitions: group, text }];
  });
}

/** The names of a label in lines. */
export function labelLines(text: string): readonly string[] {
  const lines: string[] = [];
  for (const name of text.split(/(?<=,) /)) {
    const last = lines.at(-1);
    if (last === undefined || last.length + 1 + name.length > kLine) lines.push(name);
    else lines[lines.length - 1] = `${last} ${name}`;
  }
  return lines;
}

function labelOf({ id, text }: Group) {
  const lines = labelLines(text);
  return { id: `${id}:label`, text, width: Math.max(...lines.map(({ length }) => length)) * kCharacter + 14, height: lines.length * kRsmLine + 3 };
}

export function rsmGraph(rsm: Rsm): ElkGraph {
  const any = (rsm.transitions ?? []).some((t) => t.src === undefined);
  const states = (rsm.states ?? []).map((s) => ({ id: s.name, width: Math.max(78, s.name.length * 8 + 30), height: 38 }));
  const edges: ElkEdge[] = groups(rsm).map((group) => ({
    id: group.id,
    sources: [group.src],
    targets: [group.dst],
    labels: [labelOf(group)],
  }));
  if (rsm.init !== undefined) edges.push({ id: kInit, sources: [kInit], targets: [rsm.init] });
  return {
    id: "rsm",
    layoutOptions: {
      "elk.algorithm": "layered",
      "elk.direction": "RIGHT",
      "elk.edgeRouting": "ORTHOGONAL",
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
  const arrows = groups(rsm).map((group): RsmArrow => {
    const label = edges.get(group.id)?.labels?.[0];
    const box = { x: (label?.x ?? 0) + kMargin, y: (label?.y ?? 0) + kMargin, width: label?.width ?? 0, height: label?.height ?? 0 };
    const spontaneous = group.transitions.every((t) => t.operation === undefined);
    const transitions = group.transitions.map((t) => t.id);
    return { id: group.id, transitions, points: pointsOf(edges.get(group.id)), label: { ...box, text: group.text, lines: labelLines(group.text), spontaneous } };
  });
  return {
    states: boxes.map(({ id, ...box }) => ({ ...box, name: id === kAny ? "any state" : id, kind: id === kInit ? "init" : id === kAny ? "any" : "state" })),
    arrows,
    start: pointsOf(edges.get(kInit)),
    deferrals: arrows.flatMap((arrow) => {
      const answers = rsm.transitions?.find(({ id }) => id === arrow.id)?.defer ?? [];
      return answers.flatMap((answer) => deferral(arrow.id, answer, arrows, (graph.height ?? 0) / 2 + kMargin));
    }),
    width: (graph.width ?? 0) + 2 * kMargin,
    height: (graph.height ?? 0) + 2 * kMargin,
  };
}

function pointsOf(edge: ElkEdge | undefined): readonly Point[] {
  const section = edge?.sections?.[0];
  if (section === undefined) return [];
  return [section.startPoint, ...(section.bendPoints ?? []), section.endPoint].map((p) => ({ x: p.x + kMargin, y: p.y + kMargin }));
}

function deferral(from: string, to: string, arrows: readonly RsmArrow[], middle: number): RsmDrawing["deferrals"] {
  const source = arrows.find((arrow) => arrow.id === from)?.label;
  const target = arrows.find((arrow) => arrow.transitions.includes(to))?.label;
  if (source === undefined || target === undefined) return [];
  return [{ id: `${from}:${to}`, path: deferralPath(source, target, arrows.map(({ label }) => label), middle) }];
}

/** Straight where the labels stand one above the other, beside what stands between them; else an arc around it. */
function deferralPath(source: Box, target: Box, labels: readonly Box[], middle: number): string {
  const [a, b] = [source.x + source.width / 2, target.x + target.width / 2];
  if (Math.abs(a - b) < (source.width + target.width) / 2) {
    const down = target.y > source.y;
    if (Math.abs(target.y - source.y) > kFar) {
      const [y, z] = [source.y + source.height / 2, target.y + target.height / 2];
      const between = labels.filter((label) => label.y >= Math.min(source.y, target.y) && label.y <= Math.max(source.y, target.y) && label.x < source.x + source.width && label.x + label.width > source.x);
      const left = Math.min(source.x, target.x, ...between.map(({ x }) => x)) - kArc - kArcGrowth * Math.abs(z - y);
      return `M ${source.x} ${y} C ${left} ${y}, ${left} ${z}, ${target.x} ${z}`;
    }
    return `M ${a} ${down ? source.y + source.height : source.y} L ${b} ${down ? target.y : target.y + target.height}`;
  }
  const above = source.y + source.height / 2 <= middle;
  const [from, to] = above ? [source.y, target.y] : [source.y + source.height, target.y + target.height];
  const bend = above ? Math.min(from, to) - kArc - 8 : Math.max(from, to) + kArc + 8;
  return `M ${a} ${from} C ${a} ${bend}, ${b} ${bend}, ${b} ${to}`;
}
