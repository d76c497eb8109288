// Where the value of a parameter stands: at the state, at the library state that it links, or, by `from: par.x`, at a state around it.
import { elementOf, type Tree } from "../edit/tree";
import { entryOf } from "../json";
import { declaredIn, textOf } from "../skills/declared";
import { takenBy } from "./plan";
import type { Value } from "./timeLine";

const kParameter = /^\s*par\.(\w+)\s*$/;

export function valueOf(tree: Tree, state: string, name: string): Value {
  const missing = { kind: "missing", state, name } as const;
  const declared = declaredIn(tree, state, "parameters").find((each) => each.name === name);
  if (declared === undefined) return missing;
  const value = entryOf(declared.fields, "value");
  if (value !== undefined) return { kind: "constant", state, name, element: declared.own, value };
  const from = textOf(entryOf(declared.fields, "from"));
  if (from === undefined) return missing;
  const source = takenBy(tree, state).get(name);
  if (source !== undefined) return { kind: "taken", source };
  const [, outer] = kParameter.exec(from) ?? [];
  const { parent } = elementOf(tree, state);
  if (outer === undefined || parent === "") return { kind: "computed", state, text: from };
  return valueOf(tree, parent, outer);
}
