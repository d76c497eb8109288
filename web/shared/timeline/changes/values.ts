// Gives parameters values: where the value stands (../values.ts), or at the step itself.
import type { Command } from "../../edit/commands/command";
import type { Operation } from "../../edit/apply";
import type { Exact, ExactJson } from "../../edit/exact";
import { elementOf, listOf, type Tree } from "../../edit/tree";
import { entryOf } from "../../json";
import { sourcesFor, takeFrom } from "../sources";
import type { Source } from "../timeLine";
import { valueOf } from "../values";
import { command, Impossible, stepIn, type Draft, type Supplies } from "./draft";

/** Sets a parameter to a constant, with its numbers as they were written. One that stands at a state around this one is set there. */
export const setValue = (tree: Tree, state: string, name: string, value: ExactJson, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    draft.parentOf(state);
    assign(draft, state, name, value);
    return undefined;
  });

function assign(draft: Draft, state: string, name: string, value: ExactJson): void {
  const { tree } = draft;
  const now = valueOf(tree, state, name);
  if (now.kind === "computed") throw new Impossible("it is computed: only RACE Pro can change it");
  const owner = now.kind === "taken" ? state : now.state;
  const own = listOf(tree, owner, "parameters").find((id) => elementOf(tree, id).fields["name"] === nameAt(now, name));
  if (own === undefined) {
    const after = listOf(tree, owner, "parameters").at(-1);
    const insert: Exact<Operation> = { op: "insert", parent: owner, list: "parameters", ...(after !== undefined && { after }), node: { name: nameAt(now, name), value, meta: { id: draft.newId() } } };
    draft.do(insert);
  } else {
    if (entryOf(elementOf(tree, own).fields, "from") !== undefined) draft.do({ op: "set", id: own, field: "from" });
    draft.do({ op: "set", id: own, field: "value", value });
  }
}

const nameAt = (now: ReturnType<typeof valueOf>, name: string): string => (now.kind === "constant" || now.kind === "missing" ? now.name : name);

/** Makes a parameter take what an earlier step of the task gives. */
export const setSource = (tree: Tree, step: string, name: string, source: Source, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    const plan = draft.plan(draft.parentOf(step));
    const { index } = stepIn(plan, step);
    if (!plan.steps.slice(0, index).some(({ id }) => id === source.step)) throw new Impossible("that step does not stand before this one");
    draft.do(...takeFrom(tree, step, name, source, draft.newId));
    return undefined;
  });

/** What a parameter of a step can take, the nearest first. */
export function sourcesOf(tree: Tree, steps: readonly { readonly id: string; readonly kind: string }[], step: string, domain: string | undefined): readonly Source[] {
  const before = steps.slice(0, steps.findIndex(({ id }) => id === step));
  return sourcesFor(tree, before.flatMap(({ id, kind }) => (kind === "skill" ? [{ id, kind } as const] : [])), domain);
}
