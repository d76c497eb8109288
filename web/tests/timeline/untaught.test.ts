// Steps that are to move to a pose that nobody has taught.
import { expect, test } from "vitest";
import { addSkill, addTask } from "../../shared/timeline/changes/add";
import { loopSteps } from "../../shared/timeline/changes/loop";
import { setDisabled } from "../../shared/timeline/changes/steps";
import { setValue } from "../../shared/timeline/changes/values";
import { untaughtPoses } from "../../shared/timeline/problems";
import { readApplication } from "../../shared/timeline/read";
import type { Tree } from "../../shared/edit/tree";
import { emptyApp, skillDocument, skills, stateNamed } from "../skills/fixture";
import { after, supplies } from "./after";

/** A task of two steps that move, one of them to a pose. */
function moving(pose: string): { readonly tree: Tree; readonly to: string } {
  const place = { document: "skills", id: stateNamed(skills.tree, "MoveTo") };
  const task = after(emptyApp, addTask(emptyApp, "root", 0, "My task", supplies));
  const to = after(task.tree, addSkill(task.tree, task.id, 0, place, supplies));
  const open = after(to.tree, addSkill(to.tree, task.id, 1, place, supplies));
  return { tree: after(open.tree, setValue(open.tree, to.id, "pose", pose, supplies)).tree, to: to.id };
}

const untaught = (tree: Tree, taught: readonly string[]) => untaughtPoses(readApplication(tree).root, taught);

test("a pose that nobody has taught is named with its step; one that was taught, and one that is not chosen, are not", () => {
  const { tree, to } = moving("above");
  expect(untaught(tree, ["home"])).toEqual([{ step: to, parameter: "pose", pose: "above" }]);
  expect(untaught(tree, ["home", "above"])).toEqual([]);
});

test("within a loop it is named, too, and not of a step that is off", () => {
  const { tree, to } = moving("above");
  const looped = after(tree, loopSteps(tree, [to], 3, supplies)).tree;
  expect(untaught(looped, []).map(({ step }) => step)).toEqual([to]);
  expect(untaught(after(looped, setDisabled(looped, to, true, supplies)).tree, [])).toEqual([]);
});

test("what a step before teaches is not named, nor is the step that teaches it", () => {
  const teaching = skillDocument("teaching", { rcm: 1, name: "teaching", root: { state: "None", meta: { id: "none" } }, library: [
    { state: "Teach", parameters: [{ name: "pose", type: "string", meta: { id: "teach_pose", domain: "pose", teaches: true } }], ports: [{ name: "success", when: "True", meta: { id: "teach_success" } }], meta: { id: "teach", skill: true } },
  ] });
  const { tree, to } = moving("above");
  const [task = ""] = readApplication(tree).root.steps.map(({ id }) => id);
  const teachAt = (index: number) => {
    const added = after(tree, addSkill(tree, task, index, { document: "teaching", id: "teach" }, { ...supplies, documents: [...supplies.documents, teaching] }));
    return after(added.tree, setValue(added.tree, added.id, "pose", "above", supplies)).tree;
  };
  expect(untaught(teachAt(0), [])).toEqual([]);
  expect(untaught(teachAt(2), []).map(({ step }) => step), "it comes too late").toEqual([to]);
});
