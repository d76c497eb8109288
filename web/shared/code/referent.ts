// What a name in a text of code stands for.
import { nameOfElement } from "../edit/commands/command";
import type { ListName } from "../edit/element";
import { listOf, type Tree } from "../edit/tree";
import { referencesIn } from "./references";
import { stateOf, type CodePlace } from "./scope";
import { behaviourOf, linkedBy } from "./texts";
import { usagesOf, usagesOfService, usagesOfVariable, type Usage } from "./usages";

/** An element of the document, a variable that need not be declared, or a service or what it has. */
export type Referent =
  | { readonly kind: "element"; readonly id: string }
  | { readonly kind: "variable"; readonly state: string; readonly name: string }
  | { readonly kind: "service"; readonly key: string; readonly member?: string };

const kLists: Readonly<Record<string, ListName>> = { par: "parameters", res: "results", var: "variables", port: "ports", chi: "children" };

const named = (tree: Tree, owner: string | undefined, list: ListName, name: string): Referent | undefined => {
  const id = owner === undefined ? undefined : listOf(tree, owner, list).find((each) => nameOfElement(tree, each) === name);
  return id === undefined ? undefined : { kind: "element", id };
};

/** What the last name of a path stands for; of a field of a value, what has the value. */
function referentOf(tree: Tree, state: string, [root = "", name, collection, member]: readonly string[]): Referent | undefined {
  const list = Object.hasOwn(kLists, root) ? kLists[root] : undefined;
  if (name === undefined || list === undefined) return undefined;
  const own = root === "chi" || root === "var" || linkedBy(tree, state) === undefined ? state : behaviourOf(tree, state);
  const found = named(tree, own, list, name);
  if (root === "var") return found ?? { kind: "variable", state, name };
  if (root !== "chi" || found?.kind !== "element" || member === undefined) return found;
  const inner = Object.hasOwn(kLists, collection ?? "") ? kLists[collection ?? ""] : undefined;
  return inner === undefined ? found : named(tree, behaviourOf(tree, found.id), inner, member);
}

/** What the name at a position of a text stands for; nothing: that is no name of the document, or it stands for nothing. */
export function referentAt(tree: Tree, place: CodePlace, text: string, position: number): Referent | undefined {
  const isHere = ({ from, to }: { readonly from: number; readonly to: number }) => from <= position && position <= to;
  const reference = referencesIn(text).find(({ spans }) => spans.some(isHere));
  if (reference === undefined) return undefined;
  const names = reference.names.slice(0, reference.spans.findIndex(isHere) + 1);
  const [root, key, member] = names;
  if (root === "svc") return key === undefined ? undefined : { kind: "service", key, ...(member !== undefined && { member }) };
  const state = stateOf(tree, place);
  return state === undefined ? undefined : referentOf(tree, state, names);
}

export function usagesOfReferent(tree: Tree, referent: Referent): readonly Usage[] {
  switch (referent.kind) {
    case "element":
      return usagesOf(tree, referent.id);
    case "variable":
      return usagesOfVariable(tree, referent.state, referent.name);
    case "service":
      return usagesOfService(tree, referent.key, referent.member);
  }
}
