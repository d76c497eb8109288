// What buttons, keys and drags do with steps: each is one change of the document.
import { addSkill, type SkillPlace } from "../../shared/timeline/changes/add";
import { loopSteps, unloop } from "../../shared/timeline/changes/loop";
import { duplicateStep, moveStep, removeStep, setDisabled } from "../../shared/timeline/changes/steps";
import { readApplication, type Application } from "../../shared/timeline/read";
import type { TimeLine } from "../../shared/timeline/timeLine";
import { kTimes } from "../../shared/timeline/times";
import { attempt } from "../client";
import { exactDocument, perform, tell, treeNow } from "../editing";
import type { DropPlace } from "../line/drag";
import { findStep, taskOf } from "../model";
import { go, place } from "../place";
import { focusCard, select } from "../select";
import { showSheet } from "../sheet";
import { texts } from "../texts";

interface Where extends DropPlace {
  /** For people. */
  readonly text: string;
}

const endOf = (line: TimeLine, title: string): Where | undefined => (line.form === "editable" ? { composite: line.id, index: line.steps.length, text: texts.library.into(title) } : undefined);

/** Where a skill is added that is pressed: behind the step that is selected, in the loop or task that is, else in the last task. */
export function whereToAdd(application: Application, task: string | undefined, step: string | undefined): Where | undefined {
  const found = step === undefined ? undefined : findStep(application.root, step);
  if (found?.line.form === "editable") {
    if (found.step.inner?.form === "editable" && found.step.kind === "loop") return endOf(found.step.inner, found.step.title);
    return { composite: found.line.id, index: found.line.steps.findIndex(({ id }) => id === step) + 1, text: texts.library.behind(found.step.title) };
  }
  const chosen = (step === undefined ? undefined : lineWithId(application, step)) ?? application.tasks.find(({ id }) => id === task) ?? application.tasks.at(-1);
  return chosen?.inner === undefined ? undefined : endOf(chosen.inner, chosen.title);
}

/** The loop or task of which a composite is the time line. */
const lineWithId = (application: Application, composite: string) => application.tasks.flatMap((each) => [each, ...(each.inner?.steps ?? [])]).find(({ inner }) => inner?.id === composite);

/** `opens`: on a small screen its settings, too. */
function changed(id: string | undefined, opens: boolean): void {
  if (id === undefined || id === "") return;
  select(id, opens);
  focusCard(id);
}

export function addSelectedSkill(skill: SkillPlace): void {
  const tree = treeNow();
  const where = tree === undefined ? undefined : whereToAdd(readApplication(tree), place().task, place().step);
  if (where === undefined) tell(texts.frame.notDone(tree !== undefined && !readApplication(tree).isEditable ? texts.library.onlyInPro : texts.library.taskFirst));
  else dropSkill(skill, where);
}

export const dropSkill = (skill: SkillPlace, { composite, index }: DropPlace): void => changed(perform((tree, supplies) => addSkill(tree, composite, index, skill, supplies)), true);

export function dropStep(id: string, { composite, index }: DropPlace): void {
  const tree = treeNow();
  const found = tree === undefined ? undefined : findStep(readApplication(tree).root, id);
  if (found?.line.id === composite && found.line.steps.findIndex((step) => step.id === id) === index) return;
  changed(perform((now, supplies) => moveStep(now, id, composite, index, supplies)), false);
}

/** What is selected: a step, else a task. */
const selectedId = (): string | undefined => place().step ?? place().task;

/** Later or earlier among its siblings. */
export function moveBy(id: string, by: -1 | 1): void {
  const tree = treeNow();
  const found = tree === undefined ? undefined : findStep(readApplication(tree).root, id);
  if (found === undefined) return;
  const at = found.line.steps.findIndex((step) => step.id === id) + by;
  if (at < 0 || at >= found.line.steps.length) return;
  if (perform((now, supplies) => moveStep(now, id, found.line.id, at, supplies)) !== undefined) focusCard(id);
}

export function moveSelected(by: -1 | 1): void {
  const id = selectedId();
  if (id !== undefined) moveBy(id, by);
}

export function remove(id: string): void {
  const tree = treeNow();
  const application = tree && readApplication(tree);
  const isTask = application?.tasks.some((task) => task.id === id) === true;
  const task = application && taskOf(application, id);
  const next = perform((now, supplies) => removeStep(now, id, supplies));
  if (next === undefined) return;
  if (next !== "") {
    select(next, false);
    focusCard(next);
  } else go({ step: undefined, ...(isTask ? { task: undefined } : { task: task?.id }) });
  showSheet(undefined);
}

export function removeSelected(): void {
  const id = selectedId();
  if (id !== undefined) remove(id);
}

export const duplicate = (id: string): Promise<void> =>
  attempt(async () => {
    const exact = await exactDocument();
    changed(perform((tree, supplies) => duplicateStep(tree, exact, id, supplies)), true);
  });

export function duplicateSelected(): void {
  const id = selectedId();
  if (id !== undefined) void duplicate(id);
}

export const turn = (id: string, off: boolean): void => void perform((tree, supplies) => setDisabled(tree, id, off, supplies));

export const repeat = (ids: readonly string[]): void => changed(perform((tree, supplies) => loopSteps(tree, ids, kTimes, supplies)), true);

export const repeatNoMore = (id: string): void => changed(perform((tree, supplies) => unloop(tree, id, supplies)), true);
