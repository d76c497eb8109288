// What is done if a step fails, and where its other outcomes lead.
import type { Command } from "../../edit/commands/command";
import { nameOfElement } from "../../edit/commands/command";
import { withoutCommentsOn } from "../../edit/comments/write";
import type { Tree } from "../../edit/tree";
import { skillOf } from "../../skills/skill";
import { loopOf, portsOf, type Intent } from "../plan";
import type { Failure, Goes } from "../timeLine";
import { command, Impossible, stepIn, type Draft, type Supplies } from "./draft";

/** A link to a support state, which handles failures of the step. Its id. */
function addHandler(draft: Draft, task: string, step: string, support: "retry" | "ask"): string {
  const link = draft.support(support);
  const linked = draft.tree.library.find((id) => nameOfElement(draft.tree, id) === link);
  const ports = linked === undefined ? [] : skillOf(draft.tree, linked).ports.map(({ name }) => ({ name, meta: { id: draft.newId() } }));
  const id = draft.newId();
  draft.do({ op: "insert", ...draft.last(task), node: { state: draft.freeName(task, `${nameOfElement(draft.tree, step)}_${support}`), ports, link, meta: { id } } });
  return id;
}

function removeHandler(draft: Draft, id: string): void {
  draft.do(...withoutCommentsOn(draft.tree, [id]), { op: "remove", id });
}

function requireLoop(tree: Tree, task: string): void {
  if (loopOf(tree, task) === undefined) throw new Impossible("it stands in no loop that it could end");
}

export const setFailure = (tree: Tree, step: string, failure: Failure, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    const task = draft.parentOf(step);
    const plan = draft.plan(task);
    const { intent } = stepIn(plan, step);
    if (portsOf(tree, step).errors.length === 0) throw new Impossible("it cannot fail");
    if ((failure.kind === "retry" ? failure.then : failure.kind) === "leave") requireLoop(tree, task);
    const needs = { retry: failure.kind === "retry", ask: failure.kind === "ask" || (failure.kind === "retry" && failure.then === "ask") };
    const handler = (support: "retry" | "ask"): string | undefined => {
      const now = intent[support];
      if (needs[support]) return now ?? addHandler(draft, task, step, support);
      if (now !== undefined) removeHandler(draft, now);
      return undefined;
    };
    const next: Intent = { ...intent, failure, retry: handler("retry"), ask: handler("ask") };
    draft.settle(task, plan.steps, new Map([...plan.intents, [step, next]]));
    return step;
  });

export const setOutcome = (tree: Tree, step: string, port: string, goes: Goes, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    const task = draft.parentOf(step);
    const plan = draft.plan(task);
    const { intent } = stepIn(plan, step);
    if (!intent.goes.has(port)) throw new Impossible("it has no such outcome");
    if (goes === "leave") requireLoop(tree, task);
    draft.settle(task, plan.steps, new Map([...plan.intents, [step, { ...intent, goes: new Map([...intent.goes, [port, goes]]) }]]));
    return step;
  });
