// Moves, copies, removes and disables steps.
import type { Operation } from "../../edit/apply";
import { withNewIds } from "../../edit/clipboard/paste";
import type { Command } from "../../edit/commands/command";
import { nameOfElement } from "../../edit/commands/command";
import { withoutCommentsOn } from "../../edit/comments/write";
import type { Exact, ExactJson } from "../../edit/exact";
import { exactElements, type ExactObject } from "../../edit/exactElements";
import { isBelow, type Tree } from "../../edit/tree";
import { isDisabled, type Intent } from "../plan";
import { readPlan } from "../read";
import { reasonAgainstTitle } from "./add";
import { command, Impossible, inserted, stepIn, without, type Draft, type Supplies } from "./draft";
import { keepValues } from "./kept";

const handlersOf = ({ retry, ask }: Intent): readonly string[] => [retry, ask].filter((id) => id !== undefined);

/** Gives a step, and what handles its failures, names that are free in its task. */
export function nameFree(draft: Draft, task: string, id: string, { retry, ask }: Intent, wish: string): void {
  const rename = (state: string, name: string): Exact<Operation> => ({ op: "set", id: state, field: "state", value: name });
  const name = draft.freeName(task, wish);
  draft.do(rename(id, name));
  if (retry !== undefined) draft.do(rename(retry, draft.freeName(task, `${name}_retry`)));
  if (ask !== undefined) draft.do(rename(ask, draft.freeName(task, `${name}_ask`)));
}

/** Whether names of what is to come to the task are taken there. */
const clash = (draft: Draft, task: string, ids: readonly string[]): boolean => ids.some((id) => draft.freeName(task, nameOfElement(draft.tree, id)) !== nameOfElement(draft.tree, id));

/** A step, with what handles its failures, into a composite, where it is the one at `index` of `steps`. */
export function bring(draft: Draft, id: string, intent: Intent, task: string, steps: readonly { readonly id: string; readonly kind: "skill" | "task" | "loop" }[], index: number): void {
  const all = [id, ...handlersOf(intent)];
  const isHere = draft.parentOf(id) === task;
  const taken = !isHere && clash(draft, task, all);
  // Its name must be free on both sides while it moves.
  if (taken) nameFree(draft, task, id, intent, nameOfElement(draft.tree, id));
  draft.do({ op: "move", id, ...draft.placeOf(task, steps, index) });
  if (!isHere) for (const handler of handlersOf(intent)) draft.do({ op: "move", id: handler, ...draft.last(task) });
}

/** What to do where a step would not find any more what it takes. */
export const standsBefore = (taker: string, giver: string): string => `"${giver}" has to stand before it, in the same task or loop as "${taker}"`;

/** Moves a step: `index` is its place among the others of the task. */
export const moveStep = (tree: Tree, id: string, task: string, index: number, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    const from = draft.parentOf(id);
    const plan = draft.plan(from);
    const { step, intent, index: was } = stepIn(plan, id);
    if (isBelow(tree, id, task)) throw new Impossible("it cannot be moved into itself");
    if (from === task) {
      const rest = without(plan.steps, [id]);
      const at = Math.max(0, Math.min(index, rest.length));
      if (at === was) throw new Impossible("it stands there already");
      bring(draft, id, intent, task, rest, at);
      draft.settle(task, inserted(rest, at, [step]), plan.intents, [id]);
      keepValues(tree, draft, id, standsBefore);
      return id;
    }
    const target = draft.plan(task);
    const at = Math.max(0, Math.min(index, target.steps.length));
    bring(draft, id, intent, task, target.steps, at);
    draft.settle(from, without(plan.steps, [id]), new Map([...plan.intents].filter(([each]) => each !== id)));
    draft.settle(task, inserted(target.steps, at, [step]), new Map([...target.intents, [id, intent]]), [id]);
    keepValues(tree, draft, id, standsBefore);
    return id;
  });

/** Removes a step, with all in it and the comments on it. */
export const removeStep = (tree: Tree, id: string, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    const task = draft.parentOf(id);
    const plan = draft.plan(task);
    const { intent, index } = stepIn(plan, id);
    const gone = [id, ...handlersOf(intent)];
    draft.do(...withoutCommentsOn(tree, gone), ...gone.map((each): Operation => ({ op: "remove", id: each })));
    const steps = without(plan.steps, [id]);
    draft.settle(task, steps, new Map([...plan.intents].filter(([each]) => each !== id)));
    keepValues(tree, draft, undefined, (taker) => `remove "${taker}" first`);
    return (steps[index] ?? steps.at(-1))?.id;
  });

/** A disabled step stays where it is, and nothing leads to it. */
export const setDisabled = (tree: Tree, id: string, disabled: boolean, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    const task = draft.parentOf(id);
    const plan = draft.plan(task);
    stepIn(plan, id);
    if (isDisabled(tree, id) === disabled) throw new Impossible(`it is ${disabled ? "off" : "on"} already`);
    draft.do({ op: "set", id, field: "meta", key: "disabled", ...(disabled && { value: true }) });
    draft.settle(task, plan.steps, plan.intents, disabled ? [] : [id]);
    return id;
  });

/** Copies a step behind itself. `document`: the same as the tree, as the server has written it. */
export const duplicateStep = (tree: Tree, document: ExactJson, id: string, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    const task = draft.parentOf(id);
    const plan = draft.plan(task);
    const { step, index, intent } = stepIn(plan, id);
    const texts = exactElements(document);
    const copies = new Map<string, string>();
    const copy = (of: string, name: string): ExactObject => {
      const text = texts.get(of);
      if (text === undefined) throw new Impossible("the server does not have it yet");
      return withNewIds({ ...text, state: name }, draft.newId, copies);
    };
    const name = draft.freeName(task, nameOfElement(tree, id).replace(/(\D)\d+$/, "$1"));
    draft.do({ op: "insert", ...draft.placeOf(task, plan.steps, index + 1), node: copy(id, name) });
    for (const [handler, suffix] of [[intent.retry, "retry"], [intent.ask, "ask"]] as const)
      if (handler !== undefined) draft.do({ op: "insert", ...draft.last(task), node: copy(handler, draft.freeName(task, `${name}_${suffix}`)) });
    const own = (of: string | undefined) => (of === undefined ? undefined : copies.get(of));
    const made = copies.get(id) ?? "";
    const intents = new Map([...plan.intents, [made, { ...intent, retry: own(intent.retry), ask: own(intent.ask) }]]);
    draft.settle(task, inserted(plan.steps, index + 1, [{ id: made, kind: step.kind }]), intents, [made]);
    return made;
  });

/** Gives a step or task another name for people; its state is called as before. */
export const renameStep = (tree: Tree, id: string, title: string, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    const reason = reasonAgainstTitle(title);
    if (reason !== undefined) throw new Impossible(reason);
    const parent = draft.parentOf(id);
    draft.do({ op: "set", id, field: "meta", key: "title", value: title.trim() });
    const plan = parent === "" ? undefined : readPlan(draft.tree, parent);
    if (plan !== undefined && "steps" in plan) draft.settle(parent, plan.steps, plan.intents);
    return id;
  });
