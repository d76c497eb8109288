// New steps and tasks.
import type { Command } from "../../edit/commands/command";
import { nameOfElement } from "../../edit/commands/command";
import type { Tree } from "../../edit/tree";
import { skillOf } from "../../skills/skill";
import { portsOf, type Intent } from "../plan";
import type { Goes } from "../timeLine";
import { command, Impossible, inserted, type Draft, type Supplies } from "./draft";

/** A skill of the document that is edited (`document` undefined), or of another one. */
export interface SkillPlace {
  readonly document: string | undefined;
  /** Id of the library state. */
  readonly id: string;
}

const kMostTitle = 40;

/** `Pick parts`: `PickParts`. */
export function nameFor(title: string, otherwise: string): string {
  const words = title.normalize("NFD").replace(/[^A-Za-z0-9 _-]/g, "").split(/[\s_-]+/).filter((word) => word !== "");
  const name = words.map((word) => word.charAt(0).toUpperCase() + word.slice(1)).join("");
  return /^[A-Za-z_]/.test(name) ? name.slice(0, kMostTitle) : otherwise;
}

/** What a new step does: a failure stops the task, and another outcome than the nominal one ends it, as the steps behind rely on that one. */
export function newIntent(tree: Tree, step: string): Intent {
  const goes = portsOf(tree, step).outcomes.map(({ name }): readonly [string, Goes] => [name, "end"]);
  return { failure: { kind: "stop" }, goes: new Map(goes), retry: undefined, ask: undefined, takes: new Map() };
}

function linkName(draft: Draft, { document, id }: SkillPlace): string {
  if (document === undefined) {
    if (!draft.tree.library.includes(id)) throw new Impossible("it is not in the library any more");
    return nameOfElement(draft.tree, id);
  }
  const source = draft.supplies.documents.find(({ name }) => name === document);
  if (source?.tree.elements.has(id) !== true) throw new Impossible(`it is not in the document ${document} any more`);
  return draft.copy(source, id);
}

/** Adds a step that does what a skill does, as the one at `index` of the task. */
export const addSkill = (tree: Tree, task: string, index: number, skill: SkillPlace, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    const plan = draft.plan(task);
    const link = linkName(draft, skill);
    const linked = draft.tree.library.find((id) => nameOfElement(draft.tree, id) === link);
    if (linked === undefined) throw new Impossible("it is not in the library any more");
    const ports = skillOf(draft.tree, linked).ports.map(({ name }) => ({ name, meta: { id: draft.newId() } }));
    const id = draft.newId();
    const node = { state: draft.freeName(task, link), ...(ports.length > 0 && { ports }), link, meta: { id } };
    const at = Math.max(0, Math.min(index, plan.steps.length));
    draft.do({ op: "insert", ...draft.placeOf(task, plan.steps, at), node });
    draft.settle(task, inserted(plan.steps, at, [{ id, kind: "skill" }]), new Map([...plan.intents, [id, newIntent(draft.tree, id)]]), [id]);
    return id;
  });

/** The text of an empty task; its ports as settleTask leaves them. */
export function emptyTask(name: string, id: string, newId: () => string, title?: string) {
  return {
    state: name,
    ports: [
      { name: "success", when: "True", meta: { id: newId() } },
      { name: "error", when: "False", meta: { id: newId() } },
    ],
    meta: { id, ...(title !== undefined && { title }) },
  };
}

export const reasonAgainstTitle = (title: string): string | undefined => {
  if (title.trim() === "") return "a name needs a letter";
  return Array.from(title.trim()).length > kMostTitle ? `a name has at most ${kMostTitle} characters` : undefined;
};

/** Adds a task as the one at `index` of a composite: of the application, its root. */
export const addTask = (tree: Tree, composite: string, index: number, title: string, supplies: Supplies): Command =>
  command(tree, supplies, (draft) => {
    const reason = reasonAgainstTitle(title);
    if (reason !== undefined) throw new Impossible(reason);
    const plan = draft.plan(composite);
    const id = draft.newId();
    const name = draft.freeName(composite, nameFor(title, "Task"));
    const at = Math.max(0, Math.min(index, plan.steps.length));
    draft.do({ op: "insert", ...draft.placeOf(composite, plan.steps, at), node: emptyTask(name, id, draft.newId, title.trim()) });
    draft.settle(composite, inserted(plan.steps, at, [{ id, kind: "task" }]), new Map([...plan.intents, [id, newIntent(draft.tree, id)]]));
    return id;
  });
