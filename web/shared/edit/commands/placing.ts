// Places of states and barriers, and notes about elements: entries of the document, by the ids of elements.
import { entryOf, isObject } from "../../json";
import type { Drawing, DrawnNode, Point } from "../../drawing/drawing";
import { hitIndex } from "../../drawing/hit";
import { childPath, type Node } from "../../model/model";
import type { ModelTree } from "../../model/modelTree";
import type { Tree } from "../tree";
import type { Command } from "./command";

/** A person places on this grid unless that is held off [px]. */
const kGrid = 4;

/** What the document has about where a node is. */
export interface StoredPlace extends Point {
  readonly side: DrawnNode["side"];
  readonly parent: string;
}

const nodeAt = (drawing: Drawing, path: string): DrawnNode | undefined => hitIndex(drawing).node(path);

/** The border on which the ports of the first child of each state stand, by the path of the state. */
const sides = new WeakMap<Drawing, ReadonlyMap<string, DrawnNode["side"]>>();

function sidesIn(drawing: Drawing): ReadonlyMap<string, DrawnNode["side"]> {
  const known = sides.get(drawing);
  if (known !== undefined) return known;
  const found = new Map<string, DrawnNode["side"]>();
  for (const { path, side } of drawing.nodes) {
    const parent = path.slice(0, path.lastIndexOf("/"));
    if (!found.has(parent)) found.set(parent, side);
  }
  sides.set(drawing, found);
  return found;
}

/** The point of the drawing from which the places in a state are measured, if it is drawn with its children. */
function originOf(drawing: Drawing, path: string): Point | undefined {
  const frame = nodeAt(drawing, path);
  return frame?.content && { x: frame.x + frame.content.x, y: frame.y + frame.content.y };
}

/** A point of the drawing as a place in the state at `parent`, which is drawn with its children, in whole pixels; nothing if it is not. */
export function placeOf(drawing: Drawing, point: Point, parent: { readonly path: string; readonly id: string }): StoredPlace | undefined {
  const [frame, origin] = [nodeAt(drawing, parent.path), originOf(drawing, parent.path)];
  if (frame === undefined || origin === undefined) return undefined;
  const side = sidesIn(drawing).get(frame.path) ?? "EAST";
  return { x: Math.round(point.x - origin.x), y: Math.round(point.y - origin.y), side, parent: parent.id };
}

const set = (field: "layout" | "notes", key: string, value?: StoredPlace | string) => ({ op: "set", id: "", field, key, ...(value !== undefined && { value: typeof value === "string" ? value : { ...value } }) }) as const;

/** Where a drawn node of the model is now, moved by `by`. */
function placeOfNode(drawing: Drawing, tree: ModelTree, path: string, by: Point): readonly (readonly [id: string, place: StoredPlace])[] {
  const entry = tree.get(path);
  const [drawn, parent] = [nodeAt(drawing, path), tree.get(entry?.parent ?? "")];
  if (entry?.node.id === undefined || drawn === undefined || parent?.node.id === undefined) return [];
  const place = placeOf(drawing, { x: drawn.x + by.x, y: drawn.y + by.y }, { path: parent.path, id: parent.node.id });
  return place === undefined ? [] : [[entry.node.id, { ...place, side: drawn.side }]];
}

/** The way nearest to `by` that leads a drawn node onto the grid. */
export function wayOnGrid(drawing: Drawing, tree: ModelTree, path: string, by: Point): Point {
  const [drawn, origin] = [nodeAt(drawing, path), originOf(drawing, tree.get(path)?.parent ?? "")];
  if (drawn === undefined || origin === undefined) return by;
  const way = (from: number, along: number): number => Math.round((from + along) / kGrid) * kGrid - from;
  return { x: way(drawn.x - origin.x, by.x), y: way(drawn.y - origin.y, by.y) };
}

/** Places nodes that are drawn, as `paths` in the model of the drawing, farther by `by`: one edit for all. */
export function moveNodes(drawing: Drawing, tree: ModelTree, paths: readonly string[], by: Point): Command {
  const places = paths.flatMap((path) => placeOfNode(drawing, tree, path, by));
  return places.length === 0 ? { reason: "there is nothing to move in the drawing" } : { change: { operations: places.map(([id, place]) => set("layout", id, place)) } };
}

const childrenOf = (tree: ModelTree, path: string): readonly Node[] => {
  const node = tree.get(path)?.node;
  return node?.kind === "state" ? node.children : [];
};

/** Keeps the children of a state where they are drawn. */
export function keepLayout(drawing: Drawing, tree: ModelTree, path: string): Command {
  const places = childrenOf(tree, path).flatMap((child) => placeOfNode(drawing, tree, childPath(path, child), { x: 0, y: 0 }));
  return places.length === 0 ? { reason: "no states are drawn in it" } : { change: { operations: places.map(([id, place]) => set("layout", id, place)) } };
}

/** Takes the places of the children of a state away. */
export function layOutAnew(document: Tree, tree: ModelTree, path: string): Command {
  const layout = entryOf(document.fields, "layout");
  const placed = childrenOf(tree, path).flatMap(({ id }) => (id !== undefined && isObject(layout) && Object.hasOwn(layout, id) ? [id] : []));
  return placed.length === 0 ? { reason: "all of its states are laid out automatically" } : { change: { operations: placed.map((id) => set("layout", id)) } };
}

const kNoNotes: Readonly<Record<string, string>> = {};

/** The notes of the document, by the ids of elements. */
export function notesOf(document: Tree): Readonly<Record<string, string>> {
  const meta = entryOf(document.fields, "meta");
  const notes = isObject(meta) ? entryOf(meta, "notes") : undefined;
  return isObject(notes) ? (notes as Readonly<Record<string, string>>) : kNoNotes;
}

/** Notes something about an element; an empty text takes the note away. */
export function writeNote(document: Tree, id: string, text: string): Command {
  const before = notesOf(document)[id] ?? "";
  const after = text.trim() === "" ? undefined : text;
  return (after ?? "") === before ? { reason: "the note is as it was" } : { change: { operations: [set("notes", id, after)] } };
}
