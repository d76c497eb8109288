// What a person is asked who leaves an application of RACE-One: edits that the server has refused are not saved.
import { expect, test } from "vitest";
import { apply } from "../../shared/edit/apply";
import type { Change, Notice } from "../../shared/edit/session";
import type { Tree } from "../../shared/edit/tree";
import { addSkill, addTask } from "../../shared/timeline/changes/add";
import { setValue } from "../../shared/timeline/changes/values";
import { questionOf, refusedEdit, type RefusedEdit } from "../../one/unsaved";
import type { Command } from "../../shared/edit/commands/command";
import { emptyApp, skills, stateNamed } from "../skills/fixture";
import { after, supplies } from "../timeline/after";

const kRefused: RefusedEdit = { what: "“Wait”", why: "state `Wait` was removed" };

test.each<[string, number, readonly RefusedEdit[], ReturnType<typeof questionOf>["title"], boolean]>([
  ["nothing waits and nothing was refused: all is saved", 0, [], "All is saved now", false],
  ["one waits", 1, [], "1 change is not saved yet", true],
  ["one was refused, and none waits", 0, [kRefused], "1 change was not taken", false],
  ["two were refused, and none waits", 0, [kRefused, kRefused], "2 changes were not taken", false],
  ["what was refused counts beside what waits", 1, [kRefused], "2 changes are not saved yet", true],
])("%s", (_, waiting, refused, title, loses) => {
  const question = questionOf({ waiting, refused });
  expect(question).toMatchObject({ title, loses });
  expect(question.means.some((text) => text.includes("has refused"))).toBe(refused.length > 0);
  expect(question.means.join(" ").includes("make it again") || question.means.join(" ").includes("make them again")).toBe(refused.length > 0);
});

const changeOf = (command: Command): Change => {
  if ("reason" in command) throw new Error(command.reason);
  return command.change;
};
const notice = (change: Change, message: string): Notice => ({ request: "r", change, errors: [{ path: "", code: "not_found", message }] });

test("a refused edit is named by the step that it was about, with the reason", () => {
  const task = after(emptyApp, addTask(emptyApp, "root", 0, "My task", supplies));
  const add = addSkill(task.tree, task.id, 0, { document: "skills", id: stateNamed(skills.tree, "Wait") }, supplies);
  const wait = after(task.tree, add);
  const set = setValue(wait.tree, wait.id, "seconds", 3, supplies);
  const all: readonly [Tree | undefined, Change, string][] = [
    [wait.tree, changeOf(set), "“Wait”"],
    [wait.tree, changeOf(addTask(wait.tree, "root", 1, "Another", supplies)), "“App”"],
    [wait.tree, { undo: true }, "Undo"],
    [undefined, changeOf(set), "A change"],
  ];
  for (const [tree, change, what] of all) expect(refusedEdit(tree, notice(change, "it is gone"))).toEqual({ what, why: "it is gone" });
  expect(refusedEdit(wait.tree, notice(changeOf(set), `\`${wait.id}\` was removed`)).why).toBe("state App/MyTask/Wait was removed");
});

test("a refused edit of a step that somebody has removed meanwhile still says why", () => {
  const task = after(emptyApp, addTask(emptyApp, "root", 0, "My task", supplies));
  const wait = after(task.tree, addSkill(task.tree, task.id, 0, { document: "skills", id: stateNamed(skills.tree, "Wait") }, supplies));
  const set = changeOf(setValue(wait.tree, wait.id, "seconds", 3, supplies));
  const gone = apply(wait.tree, { operations: [{ op: "remove", id: wait.id }] });
  expect("tree" in gone && refusedEdit(gone.tree, notice(set, "there is no such state"))).toEqual({ what: "A change", why: "there is no such state" });
});
