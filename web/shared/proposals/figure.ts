// What a proposal would change, as a drawing: the states around what differs are drawn open, all others closed; signs say what differs, and
// what would be removed is dashed, where it was.
import type { Drawing } from "../drawing/drawing";
import { placesIn, type Places } from "../drawing/places";
import { drawingSvg, svgElement, type SvgElement } from "../drawing/svg";
import { editedModel } from "../edit/editedModel";
import type { Element, Tree } from "../edit/tree";
import { drawnMarks, type DrawnMark } from "../live/drawnMarks";
import type { State } from "../model/model";
import { buildTree, type ModelTree } from "../model/modelTree";
import { ghostsOf, removedNodes, type DrawnModel, type Ghost } from "../versions/ghosts";
import type { Outline } from "./outline";

/** What is to be laid out of a document. */
export interface Figure {
  readonly tree: ModelTree;
  /** The root. */
  readonly state: State;
  readonly collapsed: ReadonlySet<string>;
  readonly places: Places;
}

export interface Figures {
  /** As it would be. */
  readonly now: Figure;
  /** As it was: for what would be removed, if there is something. */
  readonly was: Figure | undefined;
}

/** More states and barriers are too small to be read. */
const kMostNodes = 150;
/** More signs would hide the drawing. */
const kMostSigns = 60;

/** The state or barrier that has an element, or is it. */
function nodeOf(tree: Tree, id: string): Element | undefined {
  let at = tree.elements.get(id);
  while (at !== undefined && at.kind !== "state" && at.kind !== "barrier") at = tree.elements.get(at.parent);
  return at;
}

/** A state or barrier, and the states around it. */
function chainOf(tree: Tree, id: string): readonly string[] {
  const found: string[] = [];
  for (let at = nodeOf(tree, id); at !== undefined; at = tree.elements.get(at.parent)) found.push(at.id);
  return found;
}

function figureOf(document: Tree, open: ReadonlySet<string>): Figure {
  const { root } = editedModel(document);
  const tree = buildTree(root);
  const closed = [...tree.values()].filter(({ node, children }) => children.length > 0 && !open.has(node.id ?? ""));
  return { tree, state: root, collapsed: new Set(closed.map(({ path }) => path)), places: placesIn(document.fields["layout"]) };
}

/** How many states and barriers are drawn. */
function sizeOf({ tree, collapsed }: Figure): number {
  const hidden = new Set<string>();
  for (const { path, parent } of tree.values()) if (parent !== undefined && (hidden.has(parent) || collapsed.has(parent))) hidden.add(path);
  return tree.size - hidden.size;
}

/** Nothing, if nothing differs in what is drawn, or that is too large. */
export function figuresOf({ before, after, rows }: Outline): Figures | undefined {
  const trees = before === undefined ? [after] : [before, after];
  const chains = rows.flatMap(({ id }) => trees.map((tree) => chainOf(tree, id)));
  const shown = chains.filter((chain) => chain.at(-1) === after.root);
  if (shown.length === 0) return undefined;
  const inner = new Set([after.root, ...shown.flatMap((chain) => chain.slice(1))]);
  const [open] = [inner, new Set([after.root])].filter((each) => sizeOf(figureOf(after, each)) <= kMostNodes);
  if (open === undefined) return undefined;
  const removes = before !== undefined && removedNodes({ before, after, rows }).length > 0;
  return { now: figureOf(after, open), was: removes ? figureOf(before, open) : undefined };
}

const kSign = 9;

const markSvg = ({ box, kind, sign, text }: DrawnMark): SvgElement => {
  const [x, y] = [box.x + box.width, box.y];
  return svgElement("g", { class: `svg-mark is-${kind}` }, svgElement("title", {}, text), svgElement("circle", { cx: x, cy: y, r: kSign }), svgElement("text", { x, y: y + 4 }, sign));
};

const ghostSvg = ({ name, kind, x, y, width, height }: Ghost): SvgElement =>
  svgElement("g", { class: "svg-ghost" }, svgElement("title", {}, `Removed: ${kind} ${name}`), svgElement("rect", { x, y, width, height, rx: kind === "state" ? 12 : 2 }), ...(kind === "state" ? [svgElement("text", { x: x + 11, y: y + 20 }, name)] : []));

/** With room for what would be removed. */
function withRoom(drawing: Drawing, ghosts: readonly Ghost[]): Drawing {
  const [right, bottom] = [ghosts.map(({ x, width }) => x + width), ghosts.map(({ y, height }) => y + height)];
  return { ...drawing, width: Math.max(drawing.width, ...right), height: Math.max(drawing.height, ...bottom) };
}

/** `prefix`, `title`: as those of drawingSvg. A new document has no signs: all of it is new. */
export function figureSvg({ before, after, rows }: Outline, drawn: { readonly now: DrawnModel; readonly was: DrawnModel | undefined }, names: { readonly prefix: string; readonly title: string }): SvgElement {
  const { now, was } = drawn;
  if (before === undefined) return drawingSvg(now.drawing, names);
  const compared = { before, after, rows };
  const ghosts = was === undefined ? [] : ghostsOf(compared, was, now).slice(0, kMostSigns);
  const svg = drawingSvg(withRoom(now.drawing, ghosts), names);
  const marks = drawnMarks(compared, now).slice(0, kMostSigns);
  return { ...svg, children: [...svg.children, ...ghosts.map(ghostSvg), ...marks.map(markSvg)] };
}
