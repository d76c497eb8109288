// Parameters that take the result of an earlier step: `from: chi.STEP.res.RESULT`.
import type { Operation } from "../edit/apply";
import { nameOfElement, type NewId } from "../edit/commands/command";
import { elementOf, listOf, type Tree } from "../edit/tree";
import { entryOf } from "../json";
import { declaredIn } from "../skills/declared";
import { skillOf } from "../skills/skill";
import { isDisabled, type Intent, type PlannedStep } from "./plan";
import type { Source } from "./timeLine";

/** What a parameter of this domain can take: results of the steps before, the nearest first. */
export function sourcesFor(tree: Tree, before: readonly PlannedStep[], domain: string | undefined): readonly Source[] {
  if (domain === undefined) return [];
  return [...before].reverse().flatMap(({ id, kind }) => (kind === "skill" && !isDisabled(tree, id) ? skillOf(tree, id).results.filter((result) => result.domain === domain).map(({ name }) => ({ step: id, result: name })) : []));
}

const expression = (tree: Tree, { step, result }: Source): string => `chi.${nameOfElement(tree, step)}.res.${result}`;

/** Makes the parameter `name` of a step take a result; without `source`, it has no value any more. */
export function takeFrom(tree: Tree, step: string, name: string, source: Source | undefined, newId: NewId): readonly Operation[] {
  const own = listOf(tree, step, "parameters").find((id) => nameOfElement(tree, id) === name);
  const from = source && expression(tree, source);
  if (own === undefined) {
    const after = listOf(tree, step, "parameters").at(-1);
    return from === undefined ? [] : [{ op: "insert", parent: step, list: "parameters", ...(after !== undefined && { after }), node: { name, from, meta: { id: newId() } } }];
  }
  const { fields } = elementOf(tree, own);
  if (from === undefined) return [{ op: "remove", id: own }];
  return [
    ...(entryOf(fields, "value") === undefined ? [] : [{ op: "set", id: own, field: "value" } as const]),
    ...(entryOf(fields, "from") === from ? [] : [{ op: "set", id: own, field: "from", value: from } as const]),
  ];
}

/**
 * Parameters of `found` take from a step that stands before them: another one, where theirs does not any more. `joining`: steps that are new in their place; what
 * has no value yet takes it from one of them, or, if it is one of them, from the nearest.
 */
export function settleSources(tree: Tree, steps: readonly PlannedStep[], intents: ReadonlyMap<string, Intent>, joining: readonly string[], newId: NewId): readonly Operation[] {
  return steps.flatMap(({ id, kind }, i) => {
    if (kind !== "skill") return [];
    const before = steps.slice(0, i);
    const takes = intents.get(id)?.takes;
    return skillOf(tree, id).parameters.flatMap(({ name, domain }): readonly Operation[] => {
      const source = takes?.get(name);
      if (source !== undefined) {
        const isThere = before.some((step) => step.id === source.step);
        return takeFrom(tree, id, name, isThere ? source : sourcesFor(tree, before, domain)[0], newId);
      }
      const [nearest] = joining.length > 0 && domain === "found" ? sourcesFor(tree, before, domain) : [];
      const joins = nearest !== undefined && (joining.includes(id) || joining.includes(nearest.step));
      return joins && !hasValue(tree, id, name) ? takeFrom(tree, id, name, nearest, newId) : [];
    });
  });
}

function hasValue(tree: Tree, step: string, name: string): boolean {
  const fields = declaredIn(tree, step, "parameters").find((each) => each.name === name)?.fields;
  const value = fields && entryOf(fields, "value");
  return (value !== undefined && value !== null) || (fields !== undefined && entryOf(fields, "from") !== undefined);
}

/** What a question to a person says of the step that has failed: its name, and what went wrong, if the step says so. */
export function settleQuestion(tree: Tree, step: string, ask: string, newId: NewId): readonly Operation[] {
  const { title, results } = skillOf(tree, step);
  const parameters = declaredIn(tree, ask, "parameters");
  const has = (name: string) => parameters.some((parameter) => parameter.name === name);
  const why = has("why") && results.some(({ name }) => name === "why") ? takeFrom(tree, ask, "why", { step, result: "why" }, newId) : [];
  const own = parameters.find(({ name }) => name === "step")?.own;
  if (!has("step")) return why;
  if (own !== undefined) return entryOf(elementOf(tree, own).fields, "value") === title ? why : [...why, { op: "set", id: own, field: "value", value: title }];
  return [...why, { op: "insert", parent: ask, list: "parameters", node: { name: "step", value: title, meta: { id: newId() } } }];
}
