// What a person does at a document, as others are told.
import type { PersonActivity, PointerPlace, TextPlace } from "../../generated/messages";
import type { Point } from "../drawing/drawing";
import { idAt } from "../model/identity";
import type { ModelTree } from "../model/modelTree";
import { selectedPaths, type View } from "../session/view";

/** As the server bounds it. */
const kMaxSelection = 32;
const kMaxOffset = 1 << 20;

export interface Doing {
  readonly name: string;
  /** The model that is drawn; nothing until the document is here. */
  readonly tree: ModelTree | undefined;
  readonly view: Pick<View, "selection" | "also" | "focus">;
  readonly text: TextPlace | undefined;
  readonly pointer: PointerPlace | undefined;
}

function selectedIds(tree: ModelTree, view: Doing["view"]): readonly string[] {
  const { selection } = view;
  const all = selection?.kind === "port" ? [selection] : selectedPaths(view).map((path) => ({ kind: "node" as const, path }));
  return all.flatMap((each) => idAt(tree, each) ?? []).slice(0, kMaxSelection);
}

export function activityOf({ name, tree, view, text, pointer }: Doing): PersonActivity {
  const level = tree && idAt(tree, { kind: "node", path: view.focus ?? tree.keys().next().value ?? "" });
  const selection = tree === undefined ? [] : selectedIds(tree, view);
  return {
    name,
    ...(level !== undefined && { level }),
    ...(selection.length > 0 && { selection: [...selection] }),
    ...(text !== undefined && { text: { ...text, offset: Math.min(text.offset, kMaxOffset) } }),
    ...(pointer !== undefined && { pointer }),
  };
}

/** A point of the drawing, from the upper left corner of the node `element` that lies there. */
export function pointerAt(element: string, node: Point, point: Point): PointerPlace {
  const tenth = (value: number) => Math.round(value * 10) / 10;
  return { element, x: tenth(point.x - node.x), y: tenth(point.y - node.y) };
}
