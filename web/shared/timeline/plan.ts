// The form in which RACE-One writes a task (api/skills.md), read: what its author meant by it, for each step. Whether the document says exactly
// that, canonical.ts finds out.
import { nameOfElement } from "../edit/commands/command";
import { elementOf, listOf, type Tree } from "../edit/tree";
import { entryOf } from "../json";
import { declaredIn, linkedState, metaOf, textOf, type Declared } from "../skills/declared";
import { isSkill, skillOf, supportOf, type SkillPort } from "../skills/skill";
import type { Failure, Goes, Source, Then } from "./timeLine";

/** What is meant by a step of a task. */
export interface Intent {
  readonly failure: Failure;
  /** Of the outcomes besides the nominal one. */
  readonly goes: ReadonlyMap<string, Goes>;
  /** Ids of the states that handle its failures. */
  readonly retry: string | undefined;
  readonly ask: string | undefined;
  /** Parameters that take results of other steps. */
  readonly takes: ReadonlyMap<string, Source>;
}

/** Whether a step ends the loop around it. */
export const endsLoop = ({ failure, goes }: Intent): boolean => failure.kind === "leave" || (failure.kind === "retry" && failure.then === "leave") || [...goes.values()].includes("leave");

export type StepKind = "skill" | "task" | "loop";

export interface PlannedStep {
  readonly id: string;
  readonly kind: StepKind;
}

export interface Plan {
  readonly steps: readonly PlannedStep[];
  readonly intents: ReadonlyMap<string, Intent>;
}

export interface NoPlan {
  /** Why, for people. */
  readonly reason: string;
}

export const isDisabled = (tree: Tree, id: string): boolean => metaOf(tree, id)["disabled"] === true;
export const isLoop = (tree: Tree, id: string): boolean => metaOf(tree, id)["loop"] === true;

/** The port of what a loop repeats with which the loop ends, whatever was counted. */
export const kLeaves = "done";

/** The loop that repeats a composite. */
export function loopOf(tree: Tree, composite: string): string | undefined {
  const { parent, fields } = elementOf(tree, composite);
  return parent !== "" && isLoop(tree, parent) && entryOf(fields, "link") === undefined ? parent : undefined;
}

export const targetOf = ({ own, fields }: Declared): string | undefined => (own === undefined ? undefined : textOf(entryOf(fields, "to")));
export const conditionTerm = (step: string, port: string): string => `chi.${step}.port.${port}`;

/** The ports of a step, by what they are. */
export interface StepPorts {
  readonly nominal: string | undefined;
  readonly outcomes: readonly SkillPort[];
  readonly errors: readonly SkillPort[];
}

export function portsOf(tree: Tree, step: string): StepPorts {
  const { ports, nominal } = skillOf(tree, step);
  return {
    nominal, outcomes: ports.filter(({ name, advice }) => advice === undefined && name !== nominal), errors: ports.filter(({ advice }) => advice !== undefined),
  };
}

/** `when` of a port of a composite as the terms that RACE-One writes; nothing: it is written otherwise. */
export function termsOf(tree: Tree, composite: string, port: string): ReadonlySet<string> | undefined {
  const element = listOf(tree, composite, "ports").find((id) => nameOfElement(tree, id) === port);
  const when = element === undefined ? undefined : textOf(entryOf(elementOf(tree, element).fields, "when"));
  if (when === undefined) return undefined;
  if (when === "False") return new Set();
  const terms = when.split(" or ").map((term) => term.trim());
  return when === "True" || terms.every((term) => /^chi\.\w+\.port\.\w+$/.test(term)) ? new Set(terms) : undefined;
}

/** What a child of a task is: a step, or what handles failures; else why it is neither. */
function roleOf(tree: Tree, id: string): StepKind | "retry" | "ask" | NoPlan {
  const { kind, fields } = elementOf(tree, id);
  if (kind !== "state") return { reason: "several of its steps are done at the same time" };
  const { title } = skillOf(tree, id);
  if (entryOf(fields, "link") === undefined) {
    const own = reasonAgainstComposite(tree, id);
    return own === undefined ? (isLoop(tree, id) ? "loop" : "task") : { reason: own };
  }
  const linked = linkedState(tree, id);
  if (linked === undefined) return { reason: `what “${title}” does is missing in this application` };
  const support = supportOf(tree, linked);
  if (support === "retry" || support === "ask") return support;
  return isSkill(tree, linked) ? "skill" : { reason: `“${title}” is no skill of the library` };
}

/** What a state does itself, for people who do not program. */
const kOwn = { entry: "does something of its own when it begins", exit: "does something of its own when it ends", oracle: "chooses with which step it begins only while it runs", keep: "remembers from one time to the next where it was" } as const;

/** Why a state is no task by what it does itself. */
export function reasonAgainstComposite(tree: Tree, id: string): string | undefined {
  const { fields } = elementOf(tree, id);
  const { title } = skillOf(tree, id);
  for (const [field, text] of Object.entries(kOwn)) if (entryOf(fields, field) !== undefined) return `“${title}” ${text}`;
  if (listOf(tree, id, "actions").length > 0) return `“${title}” does something of its own while its steps are done`;
  return undefined;
}

const kTaken = /^\s*chi\.(\w+)\.res\.(\w+)\s*$/;

/** What the parameters of a step take from its siblings, by their ids. */
export function takenBy(tree: Tree, step: string): ReadonlyMap<string, Source> {
  const { parent } = elementOf(tree, step);
  const taken = new Map<string, Source>();
  for (const id of listOf(tree, step, "parameters")) {
    const [, name, result] = kTaken.exec(textOf(entryOf(elementOf(tree, id).fields, "from")) ?? "") ?? [];
    const sibling = listOf(tree, parent, "children").find((child) => nameOfElement(tree, child) === name);
    if (sibling !== undefined && result !== undefined) taken.set(nameOfElement(tree, id), { step: sibling, result });
  }
  return taken;
}

const targetAt = (tree: Tree, state: string | undefined, port: string): string | undefined => {
  const declared = state === undefined ? undefined : declaredIn(tree, state, "ports").find(({ name }) => name === port);
  return declared === undefined ? undefined : targetOf(declared);
};

function intentOf(tree: Tree, id: string, handlers: ReadonlyMap<string, { readonly id: string; readonly role: "retry" | "ask" }>, stops: ReadonlySet<string>, leaves: ReadonlySet<string>): Intent {
  const { outcomes, errors } = portsOf(tree, id);
  const then = (state: string, port: string): Then => {
    const target = targetAt(tree, state, port);
    if (target !== undefined) return handlers.get(target)?.role === "ask" ? "ask" : "next";
    const term = conditionTerm(nameOfElement(tree, state), port);
    return stops.has(term) ? "stop" : leaves.has(term) ? "leave" : "next";
  };
  const [error] = errors;
  const first = error === undefined ? undefined : handlers.get(targetAt(tree, id, error.name) ?? "");
  const retry = first?.role === "retry" ? first.id : undefined;
  const after = retry === undefined ? undefined : handlers.get(targetAt(tree, retry, "give_up") ?? "");
  const ask = first?.role === "ask" ? first.id : after?.role === "ask" ? after.id : undefined;
  const failure: Failure = retry !== undefined ? { kind: "retry", then: then(retry, "give_up") } : { kind: error === undefined ? "stop" : then(id, error.name) };
  const goes = outcomes.map(({ name: port }): readonly [string, Goes] => {
    const declared = declaredIn(tree, id, "ports").find((each) => each.name === port);
    const leads = declared !== undefined && targetOf(declared) !== undefined;
    if (!leads && leaves.has(conditionTerm(nameOfElement(tree, id), port))) return [port, "leave"];
    return [port, leads || (declared?.own !== undefined && metaOf(tree, declared.own)["next"] === true) ? "next" : "end"];
  });
  return { failure, goes: new Map(goes), retry, ask, takes: takenBy(tree, id) };
}

/** What is meant by a composite. Its steps in their order. */
export function planOf(tree: Tree, composite: string): Plan | NoPlan {
  const own = reasonAgainstComposite(tree, composite);
  if (own !== undefined) return { reason: own };
  const children = listOf(tree, composite, "children");
  const roles = children.map((id) => [id, roleOf(tree, id)] as const);
  for (const [, role] of roles) if (typeof role === "object") return role;
  const handlers = new Map(roles.flatMap(([id, role]) => (role === "retry" || role === "ask" ? [[nameOfElement(tree, id), { id, role }] as const] : [])));
  const steps = roles.flatMap(([id, role]) => (role === "skill" || role === "task" || role === "loop" ? [{ id, kind: role }] : []));
  const stops = termsOf(tree, composite, "error") ?? new Set();
  const leaves = (loopOf(tree, composite) === undefined ? undefined : termsOf(tree, composite, kLeaves)) ?? new Set();
  return { steps, intents: new Map(steps.map(({ id }) => [id, intentOf(tree, id, handlers, stops, leaves)])) };
}
