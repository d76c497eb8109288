// The application of one task that the guide makes: what it still lacks, one change after the other. What a try before has made is not made again.
import type { Command } from "../../shared/edit/commands/command";
import type { ExactJson } from "../../shared/edit/exact";
import type { Tree } from "../../shared/edit/tree";
import { addSkill, addTask, type SkillPlace } from "../../shared/timeline/changes/add";
import type { Supplies } from "../../shared/timeline/changes/draft";
import { setValue } from "../../shared/timeline/changes/values";
import { readApplication } from "../../shared/timeline/read";
import type { Step } from "../../shared/timeline/timeLine";

export interface WantedSkill {
  /** Of the library state. */
  readonly skill: string;
  readonly values: Readonly<Record<string, ExactJson>>;
}

type Lack =
  | { readonly kind: "task"; readonly root: string }
  | { readonly kind: "step"; readonly task: string; readonly index: number }
  | { readonly kind: "value"; readonly step: string; readonly parameter: string; readonly value: ExactJson };

const isUnset = (step: Step, name: string): boolean => step.parameters.find(({ about }) => about.name === name)?.value.kind === "missing";

/** The first thing that is not there; a value that a person has chosen is. */
function lackOf(tree: Tree, wanted: readonly WantedSkill[]): Lack | undefined {
  const { root, tasks } = readApplication(tree);
  const [task] = tasks;
  if (task === undefined) return { kind: "task", root: root.id };
  const steps = task.inner?.steps ?? [];
  for (const [index, { values }] of wanted.entries()) {
    const step = steps[index];
    if (step === undefined) return { kind: "step", task: task.id, index };
    for (const [parameter, value] of Object.entries(values)) if (isUnset(step, parameter)) return { kind: "value", step: step.id, parameter, value };
  }
  return undefined;
}

export const isMade = (tree: Tree, wanted: readonly WantedSkill[]): boolean => lackOf(tree, wanted) === undefined;

/** The change that it lacks next; nothing: it has all. `places`: where its skills are, one for each. */
export function nextChange(tree: Tree, title: string, wanted: readonly WantedSkill[], places: readonly SkillPlace[], supplies: Supplies): Command | undefined {
  const lack = lackOf(tree, wanted);
  if (lack === undefined) return undefined;
  if (lack.kind === "task") return addTask(tree, lack.root, 0, title, supplies);
  if (lack.kind === "value") return setValue(tree, lack.step, lack.parameter, lack.value, supplies);
  const place = places[lack.index];
  return place && addSkill(tree, lack.task, lack.index, place, supplies);
}
