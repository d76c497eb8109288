// Random changes of an application, and what its time lines are to be after each: kept by plain lists, apart from the document.
import { apply, type Operation } from "../../shared/edit/apply";
import type { Command } from "../../shared/edit/commands/command";
import { plain } from "../../shared/edit/exact";
import { Refusal } from "../../shared/edit/refusal";
import type { Tree } from "../../shared/edit/tree";
import { skillsIn } from "../../shared/skills/skill";
import { addSkill, addTask } from "../../shared/timeline/changes/add";
import type { Supplies } from "../../shared/timeline/changes/draft";
import { setFailure, setOutcome } from "../../shared/timeline/changes/failure";
import { loopSteps, repeatUntil, unloop } from "../../shared/timeline/changes/loop";
import { duplicateStep, moveStep, removeStep, renameStep, setDisabled } from "../../shared/timeline/changes/steps";
import { setSource, sourcesOf } from "../../shared/timeline/changes/values";
import { readApplication, readLoop, readTimeLine, type LoopParts } from "../../shared/timeline/read";
import type { Failure, Goes, TimeLine } from "../../shared/timeline/timeLine";
import type { Random } from "../edit/random";
import { emptyApp, exactOf, skills } from "../skills/fixture";

/** A step as it is expected: what is in it, if it is a task or a loop. */
export interface Expected {
  readonly id: string;
  kind: string;
  title: string;
  disabled: boolean;
  failure: Failure | undefined;
  goes: Record<string, Goes>;
  /** Of a loop: how often; 0: for ever, or until one of its steps says so. */
  times: number | undefined;
  steps: Expected[] | undefined;
}

/** The same of what was read; throws if a time line does not have the form. */
export function shapeOf(line: TimeLine): Expected[] {
  if (line.form !== "editable") throw new Error(`${line.id} is ${line.form}: ${line.reason}`);
  return line.steps.map(({ id, kind, title, disabled, failure, outcomes, inner, repeat }) => ({
    id, kind, title, disabled, failure, goes: Object.fromEntries(outcomes.map(({ port, goes }) => [port.name, goes])),
    times: repeat?.value.kind === "constant" && typeof repeat.value.value === "number" ? repeat.value.value : undefined, steps: inner && shapeOf(inner),
  }));
}

interface Place {
  /** Id of the composite. */
  readonly composite: string;
  /** It is what a loop repeats. */
  readonly isRepeated: boolean;
  readonly steps: Expected[];
}

const kSkills = skillsIn(skills.tree);
const kFailures: readonly Failure[] = [{ kind: "stop" }, { kind: "next" }, { kind: "ask" }, { kind: "retry", then: "stop" }, { kind: "retry", then: "next" }, { kind: "retry", then: "ask" }];
/** Of steps that are repeated, besides. */
const kLoopFailures: readonly Failure[] = [{ kind: "leave" }, { kind: "retry", then: "leave" }];

export class RandomTask {
  tree: Tree = emptyApp;
  readonly expected: Expected[] = [];
  /** Of the last change. */
  operations: readonly Operation[] = [];
  /** The steps that the last change was about. */
  named: readonly string[] = [];
  /** What counts in loops whose number the last change has settled: nothing ends them any more. */
  counts: readonly string[] = [];
  private count = 0;
  private readonly supplies: Supplies = { newId: () => `n${this.count++}`, documents: [skills] };

  /** `skills`: of which new steps are. */
  constructor(
    private readonly random: Random,
    private readonly skills = kSkills,
  ) {}

  /** One change; what it was. Requires that it is not refused, unless as another step would not find any more what it takes. */
  change(): string {
    const { random } = this;
    this.named = [];
    const places = this.places();
    const place = random.of(places);
    const kinds = [...(place.composite === "root" ? ["task"] : ["skill", "skill", "skill"]), ...(place.steps.length > 0 ? ["move", "duplicate", "disable", "remove", "failure", "outcome", "until", "until", "until", "loop", "unloop", "rename", "source"] : [])];
    const kind = this.sizeOf(this.expected) > 40 && place.steps.length > 0 ? "remove" : random.of(kinds);
    const step = place.steps.length > 0 ? random.of(place.steps) : undefined;
    const ended = this.loops().filter(isEnded);
    const what = this.make(kind, place, step);
    const settled = this.loops().filter((loop) => loop.times === 0 && ended.includes(loop) && !isEnded(loop));
    for (const loop of settled) loop.times = 3;
    this.counts = settled.map(({ id }) => this.partsOf(id).count);
    return `${kind} ${what}`;
  }

  private loops(steps: readonly Expected[] = this.expected): readonly Expected[] {
    return steps.flatMap((step) => [...(step.kind === "loop" ? [step] : []), ...this.loops(step.steps ?? [])]);
  }

  private partsOf(loop: string): LoopParts {
    const parts = readLoop(this.tree, loop);
    if ("reason" in parts) throw new Error(parts.reason);
    return parts;
  }

  private sizeOf = (steps: readonly Expected[]): number => steps.reduce((sum, { steps: inner = [] }) => sum + 1 + this.sizeOf(inner), 0);

  private places(): readonly Place[] {
    const within = (steps: readonly Expected[]): readonly Place[] => steps.flatMap((step) => (step.steps === undefined ? [] : [{ composite: this.compositeOf(step), isRepeated: step.kind === "loop", steps: step.steps }, ...within(step.steps)]));
    return [{ composite: "root", isRepeated: false, steps: this.expected }, ...within(this.expected)];
  }

  private compositeOf({ id, kind }: Expected): string {
    return kind === "loop" ? this.partsOf(id).body : id;
  }

  private take(command: Command): string {
    if ("reason" in command) throw new Error(command.reason);
    if (!("operations" in command.change)) throw new Error("the server makes this change");
    this.operations = plain<readonly Operation[]>(command.change.operations);
    const applied = apply(this.tree, { operations: this.operations });
    if (applied instanceof Refusal) throw applied;
    this.tree = applied.tree;
    return command.select ?? "";
  }

  /** The same of a change that may be refused, as another step takes what is moved; then nothing is done. */
  private attempt(command: Command): string | undefined {
    if ("reason" in command && / takes what ".*" gives: .+, or choose another ".*" there$/.test(command.reason)) return undefined;
    return this.take(command);
  }

  private make(kind: string, { composite, steps, isRepeated }: Place, step: Expected | undefined): string {
    const { random, tree, supplies } = this;
    if (kind === "task") {
      const index = random.pick(steps.length + 1);
      const title = `Task ${this.count}`;
      const id = this.take(addTask(tree, composite, index, title, supplies));
      steps.splice(index, 0, { id, kind: "task", title, disabled: false, failure: { kind: "stop" }, goes: {}, times: undefined, steps: [] });
      return id;
    }
    if (kind === "skill") {
      const skill = random.of(this.skills);
      const index = random.pick(steps.length + 1);
      const id = this.take(addSkill(tree, composite, index, { document: "skills", id: skill.id }, supplies));
      const goes = Object.fromEntries(skill.ports.filter(({ name, advice }) => advice === undefined && name !== skill.nominal).map(({ name }) => [name, "end"] as const));
      this.named = [id];
      const fails = skill.ports.some(({ advice }) => advice !== undefined);
      steps.splice(index, 0, { id, kind: "skill", title: skill.title, disabled: false, failure: fails ? { kind: "stop" } : undefined, goes, times: undefined, steps: undefined });
      return skill.name;
    }
    if (step === undefined) throw new Error("there is no step");
    const at = steps.indexOf(step);
    switch (kind) {
      case "move":
        return this.move(step, steps);
      case "duplicate": {
        this.take(duplicateStep(tree, exactOf(tree), step.id, supplies));
        const made = this.read(composite)[at + 1];
        this.named = made === undefined ? [] : [made.id];
        steps.splice(at + 1, 0, renewed(step, made));
        return step.id;
      }
      case "disable":
        step.disabled = !step.disabled;
        this.take(setDisabled(tree, step.id, step.disabled, supplies));
        this.named = [step.id];
        return step.id;
      case "remove":
        if (this.attempt(removeStep(tree, step.id, supplies)) === undefined) return "refused";
        steps.splice(at, 1);
        return step.id;
      case "failure": {
        if (step.failure === undefined) return "nothing";
        const failure = random.of([...kFailures, ...(isRepeated ? kLoopFailures : [])]);
        const command = setFailure(tree, step.id, failure, supplies);
        if ("reason" in command && JSON.stringify(failure) === JSON.stringify(step.failure)) return "as it was";
        this.take(command);
        step.failure = failure;
        return `${step.id} ${JSON.stringify(failure)}`;
      }
      case "outcome": {
        const ports = Object.keys(step.goes);
        if (ports.length === 0) return "nothing";
        const port = random.of(ports);
        const goes = random.of((["next", "end", ...(isRepeated ? (["leave"] as const) : [])] as const).filter((way) => way !== step.goes[port]));
        this.take(setOutcome(tree, step.id, port, goes, supplies));
        step.goes[port] = goes;
        return `${step.id} ${port} ${goes}`;
      }
      case "until":
        return this.until();
      case "loop":
        return this.loop(steps, at);
      case "unloop":
        if (step.kind !== "loop") return "nothing";
        this.take(unloop(tree, step.id, supplies));
        for (const inner of step.steps ?? []) staysWithin(inner);
        steps.splice(at, 1, ...(step.steps ?? []));
        this.named = (step.steps ?? []).map(({ id }) => id);
        return step.id;
      case "source":
        return this.source(step, composite);
      default:
        step.title = `Name ${this.count++}`;
        this.take(renameStep(tree, step.id, step.title, supplies));
        return step.id;
    }
  }

  private read(composite: string): Expected[] {
    const find = (steps: readonly Expected[]): Expected[] | undefined => {
      for (const step of steps) {
        if (step.steps === undefined) continue;
        const found = this.compositeOf(step) === composite ? step.steps : find(step.steps);
        if (found !== undefined) return found;
      }
      return undefined;
    };
    const all = shapeOf(readApplication(this.tree).root);
    return composite === "root" ? all : (find(all) ?? []);
  }

  private move(step: Expected, steps: Expected[]): string {
    const places = this.places().filter(({ composite, steps: there }) => composite !== "root" === (step.kind !== "task" || steps !== this.expected) && !contains(step, there));
    if (places.length === 0) return "nothing";
    const target = this.random.of(places);
    const length = target.steps.length - (target.steps === steps ? 1 : 0);
    const index = this.random.pick(length + 1);
    const command = moveStep(this.tree, step.id, target.composite, index, this.supplies);
    if ("reason" in command && target.steps === steps && steps.indexOf(step) === index) return "where it was";
    if (this.attempt(command) === undefined) return "refused";
    this.named = [step.id];
    steps.splice(steps.indexOf(step), 1);
    if (!target.isRepeated) staysWithin(step);
    target.steps.splice(index, 0, step);
    return `${step.id} to ${target.composite} at ${index}`;
  }

  /** Another part is taken than the nearest one. */
  private source({ id }: Expected, composite: string): string {
    const { steps } = readTimeLine(this.tree, composite);
    const parameter = steps.find((each) => each.id === id)?.parameters.find(({ about }) => about.domain === "found");
    const sources = parameter === undefined ? [] : sourcesOf(this.tree, steps, id, "found");
    if (parameter === undefined || sources.length === 0) return "nothing";
    const source = this.random.of(sources);
    const { value } = parameter;
    if (value.kind === "taken" && value.source.step === source.step) return "as it was";
    this.take(setSource(this.tree, id, parameter.about.name, source, this.supplies));
    this.named = [id];
    return `${id} takes what ${source.step} gives`;
  }

  /** What a loop repeats says when it ends, or no more. */
  private until(): string {
    const ends = this.loops().flatMap((loop) => (loop.steps ?? []).flatMap((step) => Object.keys(step.goes).map((port) => ({ loop, step, port }))));
    if (ends.length === 0) return "nothing";
    const chosen = ends.filter(({ step: { goes }, port }) => goes[port] === "leave");
    const { loop, step, port } = this.random.of(chosen.length > 0 && this.random.pick(2) === 0 ? chosen : ends);
    const goes = step.goes[port] === "leave" ? "end" : "leave";
    const wasEnded = isEnded(loop);
    this.take(repeatUntil(this.tree, loop.id, { step: step.id, port }, goes === "leave", this.supplies));
    step.goes[port] = goes;
    if (!wasEnded && isEnded(loop)) {
      loop.times = 0;
      this.named = [this.partsOf(loop.id).count];
    }
    return `${loop.id} ${step.id} ${port} ${goes}`;
  }

  private loop(steps: Expected[], at: number): string {
    const group = steps.slice(at, at + 1 + this.random.pick(3));
    const times = this.random.pick(3);
    if (group.some(endsLoop)) {
      const refused = loopSteps(this.tree, group.map((each) => each.id), 3, this.supplies);
      if (!("reason" in refused) || !/ends the loop around it|repeat both/.test(refused.reason)) throw new Error("a step would end another loop");
      return "refused";
    }
    const id = this.attempt(loopSteps(this.tree, group.map((each) => each.id), times, this.supplies));
    if (id === undefined) return "refused";
    steps.splice(at, group.length, { id, kind: "loop", title: "Repeat", disabled: false, failure: { kind: "stop" }, goes: {}, times, steps: group });
    return group.map((step) => step.id).join(" ");
  }
}

const endsLoop = ({ failure, goes }: Expected): boolean => failure?.kind === "leave" || (failure?.kind === "retry" && failure.then === "leave") || Object.values(goes).includes("leave");

/** A loop: a step that is on ends it. */
const isEnded = ({ steps = [] }: Expected): boolean => steps.some((step) => !step.disabled && endsLoop(step));

/** What ended a loop does what a new step does, where there is none. */
function staysWithin(step: Expected): void {
  const { failure } = step;
  if (failure?.kind === "leave") step.failure = { kind: "stop" };
  if (failure?.kind === "retry" && failure.then === "leave") step.failure = { kind: "retry", then: "stop" };
  for (const [port, goes] of Object.entries(step.goes)) if (goes === "leave") step.goes[port] = "end";
}

const contains = (step: Expected, steps: readonly Expected[]): boolean => step.steps === steps || (step.steps ?? []).some((inner) => contains(inner, steps));

/** A copy of a step, with the ids of `made`. */
function renewed(step: Expected, made: Expected | undefined): Expected {
  return { ...step, id: made?.id ?? "", goes: { ...step.goes }, steps: step.steps?.map((inner, i) => renewed(inner, made?.steps?.[i])) };
}
