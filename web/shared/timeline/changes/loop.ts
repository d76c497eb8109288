// Repeats a group of steps, and takes such a group apart again.
import type { Operation } from "../../edit/apply";
import type { Command } from "../../edit/commands/command";
import { nameOfElement } from "../../edit/commands/command";
import { withoutCommentsOn } from "../../edit/comments/write";
import { exactNumber } from "../numbers";
import type { Tree } from "../../edit/tree";
import { skillOf } from "../../skills/skill";
import { endsLoop, type Intent, type PlannedStep } from "../plan";
import { readLoop } from "../read";
import { isEnded, setTimes } from "../times";
import { emptyTask, newIntent } from "./add";
import { command, Impossible, inserted, stepIn, without, withoutLeaving, type Supplies } from "./draft";
import { keepValues } from "./kept";
import { bring, standsBefore } from "./steps";

/** Repeats steps that stand side by side `times`, or for ever (0). The loop is one step in their place. */
export const loopSteps = (tree: Tree, ids: readonly string[], times: number, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    const [one] = ids;
    if (one === undefined) throw new Impossible("nothing is selected");
    const task = draft.parentOf(one);
    const plan = draft.plan(task);
    const chosen = plan.steps.filter(({ id }) => ids.includes(id));
    const at = plan.steps.findIndex(({ id }) => id === chosen[0]?.id);
    if (chosen.length !== ids.length || chosen.some(({ id }, i) => plan.steps[at + i]?.id !== id)) throw new Impossible("the steps do not stand side by side");
    for (const { id } of chosen) if (endsLoop(stepIn(plan, id).intent)) throw new Impossible(`"${skillOf(tree, id).title}" ends the loop around it: let it do something else first`);
    const [loop, body, count] = [draft.newId(), draft.newId(), draft.newId()];
    const link = draft.support("repeat");
    const { ports: _, meta, ...node } = emptyTask(draft.freeName(task, "Loop"), loop, draft.newId, "Repeat");
    const { state: bodyName, ...empty } = emptyTask("Body", body, draft.newId);
    const linked = draft.tree.library.find((id) => nameOfElement(draft.tree, id) === link) ?? "";
    const counter = { state: "Count", parameters: [{ name: "times", value: exactNumber(times, true), meta: { id: draft.newId() } }], ports: skillOf(draft.tree, linked).ports.map(({ name }) => ({ name, meta: { id: draft.newId() } })), link, meta: { id: count } };
    draft.do({ op: "insert", ...draft.placeOf(task, plan.steps, at), node: { ...node, children: [{ state: bodyName, ...empty }, counter], meta: { ...meta, loop: true } } });
    let inner: readonly PlannedStep[] = [];
    for (const step of chosen) {
      const { intent } = stepIn(plan, step.id);
      bring(draft, step.id, intent, body, inner, inner.length);
      inner = [...inner, step];
    }
    draft.settle(body, inner, new Map(inner.map(({ id }) => [id, stepIn(plan, id).intent])));
    const rest = without(plan.steps, ids);
    const intents = new Map([...plan.intents].filter(([id]) => !ids.includes(id)));
    draft.settle(task, inserted(rest, at, [{ id: loop, kind: "loop" }]), new Map([...intents, [loop, newIntent(draft.tree, loop)]]));
    keepValues(tree, draft, undefined, () => "repeat both");
    return loop;
  });

/** An outcome of a step that a loop repeats. */
export interface Until {
  readonly step: string;
  readonly port: string;
}

/** Repeats until a step says so, or no more until then. What is the first to end a loop by its steps is not counted, unless that is set afterwards. */
export const repeatUntil = (tree: Tree, loop: string, { step, port }: Until, isEnd: boolean, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    draft.parentOf(loop);
    const parts = readLoop(tree, loop);
    if ("reason" in parts) throw new Impossible(`this can only be changed in RACE Pro: ${parts.reason}`);
    const { steps, intents } = draft.plan(parts.body);
    const intent = intents.get(step);
    if (intent?.goes.has(port) !== true) throw new Impossible("it has no such outcome");
    const next = new Map<string, Intent>([...intents, [step, { ...intent, goes: new Map([...intent.goes, [port, isEnd ? "leave" : "end"]]) }]]);
    draft.settle(parts.body, steps, next);
    if (!isEnded(tree, parts.body) && isEnded(draft.tree, parts.body)) draft.do(...setTimes(draft.tree, parts.count, 0, draft.newId));
    return loop;
  });

/** Puts the steps of a loop in its place. */
export const unloop = (tree: Tree, loop: string, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    const task = draft.parentOf(loop);
    const plan = draft.plan(task);
    const { index, intent } = stepIn(plan, loop);
    const parts = readLoop(tree, loop);
    if ("reason" in parts) throw new Impossible(`this can only be changed in RACE Pro: ${parts.reason}`);
    const body = draft.plan(parts.body);
    let steps: readonly PlannedStep[] = plan.steps;
    for (const [i, step] of body.steps.entries()) {
      bring(draft, step.id, stepIn(body, step.id).intent, task, steps, index + i);
      steps = inserted(steps, index + i, [step]);
    }
    const gone = [loop, intent.retry, intent.ask].filter((id) => id !== undefined);
    draft.do(...withoutCommentsOn(draft.tree, gone), ...gone.map((id): Operation => ({ op: "remove", id })));
    const intents = new Map([...plan.intents, ...withoutLeaving(body.intents)]);
    intents.delete(loop);
    draft.settle(task, without(steps, [loop]), intents, body.steps.map(({ id }) => id));
    keepValues(tree, draft, undefined, standsBefore);
    return body.steps[0]?.id;
  });
