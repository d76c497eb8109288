// What a program has written in the form of api/skills.md: planned.json is a root by api/examples/planner (tests/integration/test_planner_documents.py
// says so), as it stands before the server gives ids.
import { expect, test } from "vitest";
import type { JsonValue } from "../../shared/json";
import { problemsOf, untaughtPoses } from "../../shared/timeline/problems";
import { readApplication } from "../../shared/timeline/read";
import { treeOf } from "../edit/documents";
import { readJson } from "../files";

type Entries = Readonly<Record<string, JsonValue>>;

const kElements = ["children", "ports", "parameters"];
let ids = 0;

/** A state, port or parameter with an id, and all within. */
function withIds(element: Entries): JsonValue {
  const meta = { id: `id${(ids += 1)}`, ...(element["meta"] as Entries | undefined) };
  const within = Object.entries(element).map(([field, value]) => [field, kElements.includes(field) ? (value as readonly Entries[]).map(withIds) : value] as const);
  return { ...Object.fromEntries(within), meta };
}

const demo = readJson(new URL("../../../deploy/demo/skills.rcm.json", import.meta.url)) as Entries;
const planned = treeOf({ ...demo, root: withIds(readJson(new URL("planned.json", import.meta.url)) as Entries) } as JsonValue);

test("the task of a planner is an application that can be edited", () => {
  const { tasks, isEditable } = readApplication(planned);
  expect(isEditable).toBe(true);
  expect(tasks.map(({ title, inner }) => [title, inner?.form, inner?.reason])).toEqual(["Say what comes", "Cube to A1", "Box to B2", "Out of the way"].map((title) => [title, "editable", undefined]));
  expect(tasks[1]?.inner?.steps.map(({ name, failure, outcomes }) => [name, failure?.kind, outcomes.map(({ goes }) => goes)])).toEqual([["Aside", "stop", []], ["Search", "stop", ["next"]], ["Pick", "stop", []], ["Place", "stop", []]]);
  expect(tasks[0]?.inner?.steps[0]?.failure?.kind).toBe("next");
});

test("every step of it has what it needs, but for the places that the planner teaches", () => {
  const { root } = readApplication(planned);
  const here = ["robot", "gripper", "obj_rec", "db", "display", "audio", "timer"].map((key) => ({ key, type: key, available: true }));
  expect(problemsOf(planned, root, here)).toEqual([]);
  expect(untaughtPoses(root, ["home"]).map(({ pose }) => pose)).toEqual(["plan_1_A1_Cube", "plan_2_B2_Box"]);
});
