// Where a run is in its time lines, and what went wrong in it.
import { expect, test } from "vitest";
import type { JsonValue } from "../../shared/json";
import { buildTree } from "../../shared/model/modelTree";
import { readModel } from "../../shared/model/readModel";
import { activeIds, failedIn, progressIn } from "../../shared/timeline/progress";
import { readApplication } from "../../shared/timeline/read";
import { allSteps } from "../../shared/timeline/timeLine";
import { treeOf } from "../edit/documents";

const port = (name: string, id: string, more = {}) => ({ name, when: "True", meta: { id, ...more } });
const json = {
  rcm: 1 as const,
  root: {
    state: "Root", first: "Task", meta: { id: "root" },
    children: [
      {
        state: "Task", first: "A", meta: { id: "task", title: "The task" },
        children: [
          { state: "A", meta: { id: "a" }, ports: [{ ...port("success", "as"), to: "B" }, port("error", "ae", { advice: "Do it again.", title: "It is stuck" })] },
          { state: "B", meta: { id: "b" }, children: [{ state: "Inner", meta: { id: "inner" } }], first: "Inner", ports: [{ ...port("success", "bs"), to: "C" }] },
          { state: "C", meta: { id: "c" } },
          { state: "Other", meta: { id: "other" } },
        ],
      },
    ],
  },
};
const application = readApplication(treeOf(json as JsonValue));
const model = buildTree(readModel(json).root);
const steps = [...application.tasks, ...application.tasks.flatMap((task) => (task.inner === undefined ? [] : allSteps(task.inner)))];
const at = (...paths: readonly string[]) => progressIn(application.root, activeIds(paths.map((path) => `Root${path}`), model));

test("states of the run are found by their ids", () => {
  expect([...activeIds(["Root", "Root/Task/A", "Root/None"], model)]).toEqual(["root", "a"]);
});

test("what happens now is the innermost step, with what is next and what is done", () => {
  expect(at("", "/Task", "/Task/A")).toMatchObject({ now: [{ title: "The task" }, { name: "A" }], next: { name: "B" }, done: 0 });
  expect(at("", "/Task", "/Task/B", "/Task/B/Inner")).toMatchObject({ now: [{ title: "The task" }, { name: "B" }, { name: "Inner" }], next: { name: "C" } });
  expect(at("", "/Task", "/Task/C")).toMatchObject({ now: [{ title: "The task" }, { name: "C" }], next: undefined, done: 2 });
});

test("while a failure is handled, the step that has failed is what happens", () => {
  const ask = { id: "ask", name: "Ask" };
  const step = application.tasks[0]?.inner?.steps[1];
  if (step === undefined) throw new Error("there is no step");
  const line = { ...application.root, steps: [{ ...step, handlers: [ask.id] }] };
  expect(progressIn(line, new Set([ask.id]))).toMatchObject({ now: [{ name: "B" }], failing: true });
  expect(progressIn(line, new Set(["b"]))).toMatchObject({ now: [{ name: "B" }], failing: false });
});

test("a state beside the flow is shown, without a next one; without any, there is nothing", () => {
  expect(at("", "/Task", "/Task/Other")).toMatchObject({ now: [{ title: "The task" }, { name: "Other" }], next: undefined });
  expect(at("")).toMatchObject({ now: [], next: undefined, done: 0 });
});

test("an error of a step is told with its title and advice; other ports are none", () => {
  expect(failedIn(["Root/Task/B.success", "Root/Task/A.error"], model, steps)).toMatchObject({ step: { id: "a" }, title: "It is stuck", advice: "Do it again." });
  expect(failedIn(["Root/Task/A.success", "Root.error", "Root/None.error"], model, steps)).toBeUndefined();
});
