// Where a new element goes, and what it is called there.
import { elementOf, listOf, type Tree } from "../tree";
import { entryOf } from "../../json";

/** In the children of `parent`, behind `after`; without it: at the front. */
export interface Place {
  readonly parent: string;
  readonly after?: string;
}

/** A place, or why there is none. */
export type PlaceOrReason = Place | { readonly reason: string };

const linkOf = (tree: Tree, id: string): string | undefined => {
  const link = entryOf(elementOf(tree, id).fields, "link");
  return typeof link === "string" ? link : undefined;
};

/** Behind the last child of a state. */
export function placeIn(tree: Tree, id: string): PlaceOrReason {
  const element = tree.elements.get(id);
  if (element?.kind !== "state") return { reason: "only a state has states inside" };
  const link = linkOf(tree, id);
  if (link !== undefined) return { reason: `what is inside is that of the library state ${link}` };
  const last = listOf(tree, id, "children").at(-1);
  return { parent: id, ...(last !== undefined && { after: last }) };
}

/** Inside of a composite; behind a state without children, or a barrier. What stands on its own gets its first child. */
export function placeAt(tree: Tree, id: string): PlaceOrReason {
  const element = tree.elements.get(id);
  if (element === undefined) return { reason: "it is not there any more" };
  const leads = listOf(tree, id, "children").length > 0 || element.list !== "children";
  return leads ? placeIn(tree, id) : { parent: element.parent, after: id };
}
