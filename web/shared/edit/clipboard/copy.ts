// Elements of a document as text.
import type { ExactJson } from "../exact";
import { isStateList } from "../element";
import { outermost } from "../commands/references";
import type { Tree } from "../tree";
import { isExactObject, itemsOf, writeLines, type ExactObject } from "./json";

/** All elements in `value` by their ids. */
function collect(value: ExactJson | undefined, found: Map<string, ExactObject>): void {
  if (!isExactObject(value)) return;
  const { meta } = value;
  if (isExactObject(meta) && typeof meta["id"] === "string") found.set(meta["id"], value);
  for (const [key, items] of Object.entries(value)) if (isStateList(key)) itemsOf(items).forEach((item) => collect(item, found));
}

/** The text of elements of a document, which is given as the server stores it. Or why there is none. */
export function copyText(document: ExactJson, tree: Tree, ids: readonly string[]): { readonly text: string } | { readonly reason: string } {
  if (!isExactObject(document)) return { reason: "the document is none" };
  const found = new Map<string, ExactObject>();
  collect(document["root"], found);
  itemsOf(document["library"]).forEach((state) => collect(state, found));
  const [children, ports]: [ExactObject[], ExactObject[]] = [[], []];
  for (const id of outermost(tree, ids)) {
    const element = found.get(id);
    if (element === undefined) return { reason: "the server does not have it yet" };
    const kind = tree.elements.get(id)?.kind;
    if (kind === "state" || kind === "barrier") children.push(element);
    else if (kind === "port") ports.push(element);
    else return { reason: "states, barriers and ports are copied" };
  }
  if (children.length + ports.length === 0) return { reason: "nothing is selected" };
  return { text: `${writeLines({ ...(children.length > 0 && { children }), ...(ports.length > 0 && { ports }) })}\n` };
}
