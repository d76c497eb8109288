// An example as the editor would show it: every element has an id then, as the server would give it one.
import type { Example } from "./examples";
import { editedState } from "../edit/editedModel";
import { Refusal } from "../edit/refusal";
import { readTree, type Tree } from "../edit/tree";
import { isObject, type JsonObject, type JsonValue } from "../json";
import type { State } from "../model/model";

const kLists: ReadonlySet<string> = new Set(["parameters", "results", "variables", "actions", "children", "ports"]);

function withIds(element: JsonObject, id: string): JsonObject {
  const fields = Object.entries(element).map(([field, value]): readonly [string, JsonValue] => [
    field,
    kLists.has(field) && Array.isArray(value) ? (value as readonly JsonValue[]).map((each, i) => (isObject(each) ? withIds(each, `${id}-${field}${i}`) : each)) : value,
  ]);
  return { ...Object.fromEntries(fields), meta: { id } };
}

/** Throws if it is no document. */
export function exampleTree({ document }: Example): Tree {
  const json = document as unknown as JsonObject & { readonly root: JsonObject };
  const tree = readTree({ ...json, root: withIds(json.root, "root") });
  if (tree instanceof Refusal) throw new Error(tree.message);
  return tree;
}

export function exampleState(example: Example): State {
  const tree = exampleTree(example);
  return editedState(tree, tree.root);
}
