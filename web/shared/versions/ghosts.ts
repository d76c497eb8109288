// What a comparison of versions has removed from the drawing, where it was drawn before.
import type { Box, Drawing } from "../drawing/drawing";
import { nameOfElement } from "../edit/commands/command";
import type { Compared } from "../edit/difference/compare";
import { selectionsOf } from "../model/identity";
import type { ModelTree } from "../model/modelTree";

/** A state or barrier that is not there any more. */
export interface Ghost extends Box {
  readonly id: string;
  readonly name: string;
  readonly kind: "state" | "barrier";
}

/** A model as it is drawn. */
export interface DrawnModel {
  readonly tree: ModelTree;
  readonly drawing: Drawing;
}

/** The outermost removed states and barriers, of a state that is still there. */
export function removedNodes({ before, after, rows }: Pick<Compared, "before" | "after" | "rows">): readonly Pick<Ghost, "id" | "name" | "kind">[] {
  return rows.flatMap(({ kind, id }) => {
    const element = before.elements.get(id);
    const isNode = element?.kind === "state" || element?.kind === "barrier";
    if (kind !== "removed" || element === undefined || !isNode || !after.elements.has(element.parent)) return [];
    return [{ id, name: nameOfElement(before, id), kind: element.kind === "state" ? "state" : "barrier" }];
  });
}

/** The node of this id in a drawing. */
function nodeAt({ tree, drawing }: DrawnModel, id: string) {
  const selection = selectionsOf(tree).get(id);
  return selection?.kind === "node" ? drawing.nodes.find(({ path }) => path === selection.path) : undefined;
}

/** In the state around it as before: `was` and `now` are drawn alike. What is around it may be drawn closed, or not at all: then there is none. */
export function ghostsOf(compared: Pick<Compared, "before" | "after" | "rows">, was: DrawnModel, now: DrawnModel): readonly Ghost[] {
  return removedNodes(compared).flatMap((removed) => {
    const parent = compared.before.elements.get(removed.id)?.parent ?? "";
    const [box, around, shown] = [nodeAt(was, removed.id), nodeAt(was, parent), nodeAt(now, parent)];
    if (box === undefined || around === undefined || !shown?.open) return [];
    return [{ ...removed, x: shown.x + box.x - around.x, y: shown.y + box.y - around.y, width: box.width, height: box.height }];
  });
}
