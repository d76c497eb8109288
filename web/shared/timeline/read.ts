// Reads a composite as a time line.
import { nameOfElement } from "../edit/commands/command";
import { elementOf, listOf, type Tree } from "../edit/tree";
import { entryOf, type JsonValue } from "../json";
import { declaredIn, linkedState, metaOf, textOf } from "../skills/declared";
import { skillOf, supportOf, wordsOf, type Skill } from "../skills/skill";
import { settleLoop, settleTask } from "./canonical";
import { isDisabled, isLoop, kLeaves, loopOf, planOf, portsOf, reasonAgainstComposite, targetOf, type Intent, type NoPlan, type Plan, type PlannedStep } from "./plan";
import { settleSources } from "./sources";
import type { Step, StepParameter, TimeLine } from "./timeLine";
import { valueOf } from "./values";

const kNoId = () => "new";

/** What is meant by a task that has the form of api/skills.md; else why it has not. */
export function readPlan(tree: Tree, composite: string): Plan | NoPlan {
  const plan = planOf(tree, composite);
  if ("reason" in plan) return plan;
  const ports = listOf(tree, composite, "ports").map((id) => nameOfElement(tree, id));
  const own = ["success", "error", ...(loopOf(tree, composite) === undefined ? [] : [kLeaves])];
  const another = ports.find((port) => !own.includes(port));
  if (another !== undefined) return { reason: `it can also end in another way, “${wordsOf(another)}”` };
  if (listOf(tree, composite, "children").length === 0) return plan; // the first change writes its ports
  const changes = [...settleTask(tree, composite, plan.steps, plan.intents, kNoId), ...settleSources(tree, plan.steps, plan.intents, [], kNoId)];
  const isMark = (change: (typeof changes)[number]) => change.op === "set" && change.field === "meta";
  return changes.every(isMark) ? plan : { reason: "its steps are not simply done one after the other" };
}

/** The parts of a loop that has the form of api/skills.md. */
export interface LoopParts {
  readonly body: string;
  readonly count: string;
}

/** What is in a loop: what it repeats, and what counts. */
export function partsOf(tree: Tree, loop: string): LoopParts | undefined {
  const children = listOf(tree, loop, "children");
  const isCount = (id: string) => {
    const linked = linkedState(tree, id);
    return linked !== undefined && supportOf(tree, linked) === "repeat";
  };
  const [count, body] = [children.find(isCount), children.find((id) => elementOf(tree, id).kind === "state" && entryOf(elementOf(tree, id).fields, "link") === undefined)];
  return count === undefined || body === undefined || children.length !== 2 ? undefined : { body, count };
}

export function readLoop(tree: Tree, loop: string): LoopParts | NoPlan {
  const own = reasonAgainstComposite(tree, loop);
  if (own !== undefined) return { reason: own };
  const parts = partsOf(tree, loop);
  const isForm = parts !== undefined && settleLoop(tree, loop, parts.body, parts.count, kNoId).length === 0;
  return isForm ? parts : { reason: "it is repeated in a way of its own" };
}

/** What a state declares, with where each value comes from. */
export function parametersOf(tree: Tree, id: string, { parameters }: Skill = skillOf(tree, id)): readonly StepParameter[] {
  return parameters.map((about) => {
    const value = valueOf(tree, id, about.name);
    // What is found has no constant.
    const isNothing = about.domain === "found" && value.kind === "constant" && value.value === null;
    return { about, value: isNothing ? { kind: "missing", state: value.state, name: value.name } : value };
  });
}

const timesOf = (tree: Tree, id: string): StepParameter | undefined => parametersOf(tree, id).find(({ about }) => about.name === "times");

function plannedStep(tree: Tree, { id, kind }: PlannedStep, { failure, goes, retry, ask }: Intent): Step {
  const base = anyStep(tree, id, kind);
  const { outcomes, errors } = portsOf(tree, id);
  return { ...base, failure: errors.length === 0 ? undefined : failure, handlers: [retry, ask].filter((handler) => handler !== undefined), times: retry === undefined ? undefined : timesOf(tree, retry), outcomes: outcomes.map((port) => ({ port, goes: goes.get(port.name) ?? "end" })) };
}

/** A step as it can be read of any state, or barrier. */
function anyStep(tree: Tree, id: string, kind: Step["kind"]): Step {
  const about = elementOf(tree, id).kind === "state" ? skillOf(tree, id) : barrierSkill(tree, id);
  const loop = kind === "loop" ? readLoop(tree, id) : undefined;
  const inner = loop !== undefined && "body" in loop ? loop.body : kind === "task" || kind === "loop" ? id : undefined;
  return {
    id, name: nameOfElement(tree, id), kind, about, title: about.title, disabled: isDisabled(tree, id), failure: undefined, handlers: [], times: undefined, outcomes: [], errors: about.ports.filter(({ advice }) => advice !== undefined),
    parameters: elementOf(tree, id).kind === "state" ? parametersOf(tree, id, about) : [], inner: inner === undefined ? undefined : readTimeLine(tree, inner),
    repeat: loop !== undefined && "count" in loop ? timesOf(tree, loop.count) : undefined,
    counter: loop !== undefined && "count" in loop ? loop.count : undefined,
  };
}

function barrierSkill(tree: Tree, id: string): Skill {
  const to = entryOf(elementOf(tree, id).fields, "to");
  const names = Array.isArray(to) ? to.filter((name): name is string => typeof name === "string") : [];
  const name = nameOfElement(tree, id);
  return { id, name, title: `At once: ${names.map(wordsOf).join(", ")}`, icon: undefined, category: "flow", doc: undefined, parameters: [], results: [], ports: [], nominal: undefined };
}

/** The kind of a state in a task that is only read. */
function kindOf(tree: Tree, id: string): Step["kind"] {
  const { kind, fields } = elementOf(tree, id);
  if (kind === "barrier") return "barrier";
  if (entryOf(fields, "link") !== undefined) return "skill";
  return isLoop(tree, id) ? "loop" : listOf(tree, id, "children").length > 0 ? "task" : "state";
}

/** Where the nominal flow goes from a child: by its nominal port, or all that a barrier leads to, which is one step. */
function nextOf(tree: Tree, id: string): string | undefined {
  const { kind, fields } = elementOf(tree, id);
  if (kind === "barrier") {
    const to = entryOf(fields, "to");
    const names: readonly JsonValue[] = Array.isArray(to) ? to : [];
    return names.length === 1 ? textOf(names[0]) : undefined;
  }
  const { nominal } = portsOf(tree, id);
  const port = declaredIn(tree, id, "ports").find(({ name }) => name === nominal);
  return port && targetOf(port);
}

/** The nominal flow of any composite. */
function flowOf(tree: Tree, composite: string): { readonly steps: readonly string[]; readonly again: string | undefined } {
  const byName = new Map(listOf(tree, composite, "children").map((id) => [nameOfElement(tree, id), id]));
  const steps: string[] = [];
  const first = textOf(entryOf(elementOf(tree, composite).fields, "first"));
  for (let at = byName.get(first ?? ""); at !== undefined; at = byName.get(nextOf(tree, at) ?? "")) {
    if (steps.includes(at)) return { steps, again: at };
    steps.push(at);
  }
  return { steps, again: undefined };
}

function readOnly(tree: Tree, composite: string, reason: string): TimeLine {
  const { steps, again } = flowOf(tree, composite);
  const step = (id: string) => anyStep(tree, id, kindOf(tree, id));
  const others = listOf(tree, composite, "children").filter((id) => !steps.includes(id));
  return { id: composite, title: skillOf(tree, composite).title, form: steps.length === 0 ? "list" : "rich", reason, steps: steps.map(step), others: others.map(step), again, isRepeated: false };
}

/** Of a tree, each composite is read once. */
const known = new WeakMap<Tree, Map<string, TimeLine>>();

/** Requires the id of a state. */
export function readTimeLine(tree: Tree, composite: string): TimeLine {
  const lines = known.get(tree) ?? new Map<string, TimeLine>();
  known.set(tree, lines);
  const line = lines.get(composite) ?? makeTimeLine(tree, composite);
  lines.set(composite, line);
  return line;
}

function makeTimeLine(tree: Tree, composite: string): TimeLine {
  const plan = readPlan(tree, composite);
  if ("reason" in plan) return readOnly(tree, composite, plan.reason);
  const steps = plan.steps.map((step) => {
    const intent = plan.intents.get(step.id);
    return intent === undefined ? anyStep(tree, step.id, step.kind) : plannedStep(tree, step, intent);
  });
  return { id: composite, title: skillOf(tree, composite).title, form: "editable", reason: undefined, steps, others: [], again: undefined, isRepeated: loopOf(tree, composite) !== undefined };
}

/** The application: its tasks are the children of the root, in one flow; or the root itself is the one task, if what is in it are no tasks. */
export interface Application {
  readonly root: TimeLine;
  readonly tasks: readonly Step[];
  /** Tasks can be added, and changed in their order. */
  readonly isEditable: boolean;
}

export function readApplication(tree: Tree): Application {
  const root = readTimeLine(tree, tree.root);
  const all = [...root.steps, ...root.others];
  const areTasks = all.every(({ kind }) => kind === "task" || kind === "loop");
  if (areTasks && (all.length > 0 || root.form === "editable")) return { root, tasks: all, isEditable: root.form === "editable" };
  return { root, tasks: [{ ...anyStep(tree, tree.root, "task"), inner: root }], isEditable: false };
}

/** What people call the application, if they have said so. */
export const applicationTitle = (tree: Tree): string | undefined => textOf(entryOf(metaOf(tree, tree.root), "title"));
