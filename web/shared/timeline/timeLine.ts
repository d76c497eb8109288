// A task as a time line of steps, as RACE-One shows it (api/skills.md).
import type { JsonValue } from "../json";
import type { Skill, SkillParameter, SkillPort } from "../skills/skill";

/** What an error leads to; `leave`: the loop around it ends, well. */
export type Then = "stop" | "next" | "ask" | "leave";

/** What is done if a step fails. */
export type Failure = { readonly kind: Then } | { readonly kind: "retry"; readonly then: Then };

/** Where an outcome that is no error leads: to the next step; to the end of the task, as `success`; or to that of the loop around it. */
export type Goes = "next" | "end" | "leave";

/** A parameter of a step takes a result of an earlier one. */
export interface Source {
  /** Id of the step. */
  readonly step: string;
  readonly result: string;
}

/** Where the value of a parameter comes from. */
export type Value =
  /** `state`: the state that has it, or that links the library state that has it; `element`: the parameter there, if it is the state's own. */
  | { readonly kind: "constant"; readonly state: string; readonly name: string; readonly element: string | undefined; readonly value: JsonValue }
  | { readonly kind: "taken"; readonly source: Source }
  /** An expression of `state`, which is written in RACE Pro. */
  | { readonly kind: "computed"; readonly state: string; readonly text: string }
  /** Whoever starts or links the state has to give one. */
  | { readonly kind: "missing"; readonly state: string; readonly name: string };

export interface StepParameter {
  readonly about: SkillParameter;
  readonly value: Value;
}

export interface Outcome {
  readonly port: SkillPort;
  readonly goes: Goes;
}

export interface Step {
  readonly id: string;
  /** Of the state. */
  readonly name: string;
  readonly kind: "skill" | "task" | "loop" | "state" | "barrier";
  /** What the state is: of a skill, with what the link says. */
  readonly about: Skill;
  readonly title: string;
  readonly disabled: boolean;
  /** Nothing: it has no errors, or the time line cannot be changed. */
  readonly failure: Failure | undefined;
  /** Ids of the states that handle its failures. */
  readonly handlers: readonly string[];
  /** How often it is tried again, the parameter of its `Retry`. */
  readonly times: StepParameter | undefined;
  /** Besides the nominal one. */
  readonly outcomes: readonly Outcome[];
  readonly errors: readonly SkillPort[];
  readonly parameters: readonly StepParameter[];
  /** Of a task and a loop: what is done in it. */
  readonly inner: TimeLine | undefined;
  /** Of a loop: how often. */
  readonly repeat: StepParameter | undefined;
  /** Of a loop: id of the state that counts its rounds. */
  readonly counter: string | undefined;
}

export interface TimeLine {
  /** Id of the composite. */
  readonly id: string;
  readonly title: string;
  /** `editable`: it has the form of api/skills.md. `rich`: one nominal flow, to be read, with constants that can be set. `list`: what is in it. */
  readonly form: "editable" | "rich" | "list";
  /** Why it is not editable, for people. */
  readonly reason: string | undefined;
  readonly steps: readonly Step[];
  /** What the nominal flow does not come by. */
  readonly others: readonly Step[];
  /** Id of the step to which the last one leads back. */
  readonly again: string | undefined;
  /** It is what a loop repeats: steps can end the loop. */
  readonly isRepeated: boolean;
}

/** All steps of time lines, with those within. */
export function allSteps(line: TimeLine): readonly Step[] {
  return [...line.steps, ...line.others].flatMap((step) => [step, ...(step.inner === undefined ? [] : allSteps(step.inner))]);
}
