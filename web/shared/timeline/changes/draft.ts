// A change of a time line while it is made: operations, and the tree with them.
import { apply, type Operation } from "../../edit/apply";
import type { Command, NewId } from "../../edit/commands/command";
import { freeName, nameOfElement } from "../../edit/commands/command";
import { plain, type Exact } from "../../edit/exact";
import { Refusal } from "../../edit/refusal";
import { elementOf, listOf, type Tree } from "../../edit/tree";
import { copyState, type SkillDocument } from "../../skills/copy";
import { supportOf, type Support } from "../../skills/skill";
import { settleLoop, settleTask } from "../canonical";
import { endsLoop, loopOf, type Intent, type Plan, type PlannedStep } from "../plan";
import { partsOf, readPlan } from "../read";
import { settleQuestion, settleSources } from "../sources";
import type { Then } from "../timeLine";
import { settleTimes } from "../times";

/** What a change needs besides the document: where skills and support states come from. */
export interface Supplies {
  readonly newId: NewId;
  /** Documents with skills. */
  readonly documents: readonly SkillDocument[];
}

/** Why a change cannot be made. */
export class Impossible extends Error {}

export class Draft {
  readonly operations: Exact<Operation>[] = [];
  private readonly plans = new Map<string, Plan>();

  constructor(
    public tree: Tree,
    readonly supplies: Supplies,
  ) {}

  get newId(): NewId {
    return this.supplies.newId;
  }

  do(...operations: readonly Exact<Operation>[]): void {
    if (operations.length === 0) return;
    const applied = apply(this.tree, { operations: plain<readonly Operation[]>(operations) });
    if (applied instanceof Refusal) throw new Impossible(applied.message);
    this.tree = applied.tree;
    this.operations.push(...operations);
  }

  /** What is meant by a task before it is changed. Throws Impossible if it is none that can be changed. */
  plan(task: string): Plan {
    const known = this.plans.get(task);
    if (known !== undefined) return known;
    if (!this.tree.elements.has(task)) throw new Impossible("it is not there any more");
    const plan = readPlan(this.tree, task);
    if ("reason" in plan) throw new Impossible(`this task can only be changed in RACE Pro: ${plan.reason}`);
    this.plans.set(task, plan);
    return plan;
  }

  /** Makes the document say what is meant now. `joining`: steps that are new in their place. */
  settle(task: string, steps: readonly PlannedStep[], intents: ReadonlyMap<string, Intent>, joining: readonly string[] = []): void {
    const loop = loopOf(this.tree, task);
    const possible = loop === undefined ? withoutLeaving(intents) : intents;
    this.plans.set(task, { steps, intents: possible });
    this.do(...settleTask(this.tree, task, steps, possible, this.newId));
    const parts = loop === undefined ? undefined : partsOf(this.tree, loop);
    if (loop !== undefined && parts !== undefined) this.do(...settleLoop(this.tree, loop, parts.body, parts.count, this.newId));
    this.do(...settleSources(this.tree, steps, intents, joining, this.newId));
    for (const [step, { ask }] of intents) if (ask !== undefined) this.do(...settleQuestion(this.tree, step, ask, this.newId));
  }

  /** Behind which child a step stands that is to be the one at `index` among `steps`. */
  placeOf(task: string, steps: readonly PlannedStep[], index: number): { readonly parent: string; readonly list: "children"; readonly after?: string } {
    const after = steps[index - 1]?.id;
    return { parent: task, list: "children", ...(after !== undefined && { after }) };
  }

  last(task: string): { readonly parent: string; readonly list: "children"; readonly after?: string } {
    const after = listOf(this.tree, task, "children").at(-1);
    return { parent: task, list: "children", ...(after !== undefined && { after }) };
  }

  freeName(task: string, wish: string): string {
    return freeName(this.tree, listOf(this.tree, task, "children"), wish);
  }

  /** The library state of the document that is this support, brought there if need be. Throws Impossible. */
  support(support: Support): string {
    const own = this.tree.library.find((id) => supportOf(this.tree, id) === support);
    if (own !== undefined) return nameOfElement(this.tree, own);
    for (const document of this.supplies.documents) {
      const id = document.tree.library.find((each) => supportOf(document.tree, each) === support);
      if (id !== undefined) return this.copy(document, id);
    }
    throw new Impossible(`no document on the server has what "${kSupportTexts[support]}" is made of`);
  }

  /** Brings a library state of another document; its name here. Throws Impossible. */
  copy(document: SkillDocument, id: string): string {
    const copied = copyState(this.tree, document, id, this.newId);
    if ("reason" in copied) throw new Impossible(copied.reason);
    this.do(...copied.operations);
    return copied.link;
  }

  parentOf(id: string): string {
    const element = this.tree.elements.get(id);
    if (element === undefined) throw new Impossible("it is not there any more");
    return element.parent;
  }
}

const kSupportTexts: Readonly<Record<Support, string>> = { retry: "try again", ask: "ask a person", repeat: "repeat" };

/** Makes a change: `work` gives the id of what is to be selected then. */
export function command(tree: Tree, supplies: Supplies, work: (draft: Draft) => string | undefined): Command {
  const draft = new Draft(tree, supplies);
  try {
    const select = work(draft);
    draft.do(...settleTimes(tree, draft.tree, draft.newId));
    if (draft.operations.length === 0) return { reason: "it is so already" };
    return { change: { operations: draft.operations }, ...(select !== undefined && { select }) };
  } catch (error) {
    if (error instanceof Impossible) return { reason: error.message };
    throw error;
  }
}

/** Steps where there is no loop to end: they do what new ones do. */
export function withoutLeaving(intents: ReadonlyMap<string, Intent>): ReadonlyMap<string, Intent> {
  const stays = (then: Then): Then => (then === "leave" ? "stop" : then);
  const change = (intent: Intent): Intent => ({
    ...intent, failure: intent.failure.kind === "retry" ? { kind: "retry", then: stays(intent.failure.then) } : { kind: stays(intent.failure.kind) },
    goes: new Map([...intent.goes].map(([port, goes]) => [port, goes === "leave" ? "end" : goes])),
  });
  return new Map([...intents].map(([id, intent]) => [id, endsLoop(intent) ? change(intent) : intent]));
}

export const without = (steps: readonly PlannedStep[], ids: readonly string[]): readonly PlannedStep[] => steps.filter(({ id }) => !ids.includes(id));

export const inserted = (steps: readonly PlannedStep[], index: number, added: readonly PlannedStep[]): readonly PlannedStep[] => [...steps.slice(0, index), ...added, ...steps.slice(index)];

/** Throws Impossible if the step is none of the task. */
export function stepIn(plan: Plan, id: string): { readonly step: PlannedStep; readonly index: number; readonly intent: Intent } {
  const index = plan.steps.findIndex((step) => step.id === id);
  const [step, intent] = [plan.steps[index], plan.intents.get(id)];
  if (step === undefined || intent === undefined) throw new Impossible("it is not there any more");
  return { step, index, intent };
}

export const isState = (tree: Tree, id: string): boolean => tree.elements.get(id)?.kind === "state" && elementOf(tree, id).list !== undefined;
