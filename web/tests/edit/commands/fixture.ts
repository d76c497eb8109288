// A document to give commands, and what they make of it.
import type { Command } from "../../../shared/edit/commands/command";
import { apply, type Operation } from "../../../shared/edit/apply";
import { plain } from "../../../shared/edit/exact";
import { Refusal } from "../../../shared/edit/refusal";
import { elementOf, listOf, type Tree } from "../../../shared/edit/tree";
import { nameOfElement } from "../../../shared/edit/commands/command";
import type { JsonObject } from "../../../shared/json";
import { treeOf } from "../documents";

const id = (name: string) => ({ meta: { id: name } });

/** Root: A (first; done -> B), B (done -> Both), C with D and E inside, the barrier Both -> C; the library has Pick, which L links. */
export const document: Tree = treeOf({
  rcm: 1,
  library: [{ state: "Pick", ...id("pick"), ports: [{ name: "done", when: "True", ...id("pick-done") }, { name: "failed", when: "False", ...id("pick-failed") }] }],
  root: {
    state: "Root", ...id("root"), first: "A",
    children: [
      { state: "A", ...id("a"), ports: [{ name: "done", when: "True", to: "B", ...id("a-done") }] },
      { state: "B", ...id("b"), ports: [{ name: "done", when: "True", to: "Both", ...id("b-done") }] },
      { state: "C", ...id("c"), first: "D", children: [{ state: "D", ...id("d"), ports: [{ name: "done", when: "True", to: "E", ...id("d-done") }] }, { state: "E", ...id("e") }] },
      { barrier: "Both", to: ["C", "A"], ...id("both") },
      { state: "L", link: "Pick", ...id("l") },
    ],
  },
});

/** The document with other fields of one element. */
export const withFields = (id: string, fields: JsonObject): Tree => ({ ...document, elements: new Map([...document.elements, [id, { ...elementOf(document, id), fields }]]) });

/** Ids `n1`, `n2`, ... */
export function newIds(): () => string {
  let count = 0;
  return () => `n${++count}`;
}

/** The document after a command; requires one of operations. */
export function after(command: Command, tree = document): Tree {
  if ("reason" in command) throw new Error(command.reason);
  if (!("operations" in command.change)) throw new Error("the server makes this change");
  const result = apply(tree, { operations: plain<readonly Operation[]>(command.change.operations) });
  if (result instanceof Refusal) throw result;
  return result.tree;
}

export const compoundOf = (command: Command) => ("change" in command && "compound" in command.change ? command.change.compound : command);
export const reasonOf = (command: Command) => ("reason" in command ? command.reason : undefined);

/** Names of the children of a state. */
export const childrenOf = (tree: Tree, id: string): readonly string[] => listOf(tree, id, "children").map((child) => nameOfElement(tree, child));
export const field = (tree: Tree, id: string, name: string): unknown => elementOf(tree, id).fields[name];
