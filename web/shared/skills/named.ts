// The poses and labels that a document names: what fields can offer.
import type { Tree } from "../edit/tree";
import { entryOf, type JsonValue } from "../json";
import { declaredIn } from "./declared";
import { parameterOf } from "./skill";

export interface Named {
  readonly poses: readonly string[];
  readonly labels: readonly string[];
}

const textsIn = (value: JsonValue | undefined): readonly string[] => (typeof value === "string" ? [value] : Array.isArray(value) ? value.filter((item) => typeof item === "string") : []);

/** Models without skills call them so. */
const kLabels: ReadonlySet<string> = new Set(["label", "labels"]);

const known = new WeakMap<Tree, Named>();

/** Each once, in the order of the document. */
export function namedIn(tree: Tree): Named {
  const before = known.get(tree);
  if (before !== undefined) return before;
  const [poses, labels] = [new Set<string>(), new Set<string>()];
  for (const { id, kind } of tree.elements.values()) {
    if (kind !== "state") continue;
    for (const declared of declaredIn(tree, id, "parameters")) {
      const domain = parameterOf(declared).domain ?? declared.name;
      const into = domain === "pose" ? poses : kLabels.has(domain) ? labels : undefined;
      if (into !== undefined && (domain !== "pose" || declared.meta["domain"] === "pose")) for (const text of textsIn(entryOf(declared.fields, "value"))) into.add(text);
    }
  }
  const named: Named = { poses: [...poses], labels: [...labels] };
  known.set(tree, named);
  return named;
}
