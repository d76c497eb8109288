// Composites read as time lines: what can be changed, what can be read, and where the values of parameters stand.
import { expect, test } from "vitest";
import { apply, type Operation } from "../../shared/edit/apply";
import type { Command } from "../../shared/edit/commands/command";
import { readExact, writeExact } from "../../shared/edit/exact";
import { Refusal } from "../../shared/edit/refusal";
import { elementOf, listOf, type Tree } from "../../shared/edit/tree";
import { nameOfElement } from "../../shared/edit/commands/command";
import type { JsonValue } from "../../shared/json";
import { addSkill, addTask, nameFor } from "../../shared/timeline/changes/add";
import { setFailure, setOutcome } from "../../shared/timeline/changes/failure";
import { loopSteps } from "../../shared/timeline/changes/loop";
import { moveStep, removeStep, renameStep, setDisabled } from "../../shared/timeline/changes/steps";
import { setSource, setValue, sourcesOf } from "../../shared/timeline/changes/values";
import { problemsOf } from "../../shared/timeline/problems";
import { readApplication, readTimeLine } from "../../shared/timeline/read";
import { treeOf } from "../edit/documents";
import { readJson } from "../files";
import { emptyApp, skills, stateNamed } from "../skills/fixture";
import { after, supplies } from "./after";

/** An application of one task with these skills. */
function appOf(...names: readonly string[]): { readonly tree: Tree; readonly task: string; readonly steps: readonly string[] } {
  const made = after(emptyApp, addTask(emptyApp, "root", 0, "My task", supplies));
  const task = made.id;
  let { tree } = made;
  const steps = names.map((name, i) => {
    const next = after(tree, addSkill(tree, task, i, { document: "skills", id: stateNamed(skills.tree, name) }, supplies));
    tree = next.tree;
    return next.id;
  });
  return { tree, task, steps };
}

const lineOf = (tree: Tree, task: string) => readTimeLine(tree, task);
const reasonOf = (command: Command) => ("reason" in command ? command.reason : undefined);
const targets = (tree: Tree, id: string) => Object.fromEntries(listOf(tree, id, "ports").map((port) => [nameOfElement(tree, port), elementOf(tree, port).fields["to"]]));
const conditions = (tree: Tree, id: string) => Object.fromEntries(listOf(tree, id, "ports").map((port) => [nameOfElement(tree, port), elementOf(tree, port).fields["when"]]));

test("an empty document is an application without tasks, which can get some", () => {
  expect(readApplication(emptyApp)).toMatchObject({ tasks: [], isEditable: true });
});

test("a task is written as api/skills.md says", () => {
  const { tree, task, steps: [move, say] } = appOf("MoveTo", "Say");
  expect(nameOfElement(tree, task)).toBe("MyTask");
  expect(elementOf(tree, task).fields["first"]).toBe("MoveTo");
  expect(targets(tree, move ?? "")).toEqual({ success: "Say", unknown: undefined, error: undefined });
  expect(conditions(tree, task)).toEqual({ success: "chi.Say.port.success", error: "chi.MoveTo.port.unknown or chi.MoveTo.port.error or chi.Say.port.error" });
  expect(conditions(tree, "root")).toEqual({ success: "chi.MyTask.port.success", error: "chi.MyTask.port.error" });
  const failing = after(tree, setFailure(tree, move ?? "", { kind: "retry", then: "ask" }, supplies)).tree;
  expect(targets(failing, move ?? "")).toEqual({ success: "Say", unknown: "MoveTo_retry", error: "MoveTo_retry" });
  const children = listOf(failing, task, "children").map((id) => [nameOfElement(failing, id), targets(failing, id)]);
  expect(children.slice(2)).toEqual([["MoveTo_retry", { again: "MoveTo", give_up: "MoveTo_ask" }], ["MoveTo_ask", { retry: "MoveTo", skip: "Say", abort: undefined }]]);
  expect(conditions(failing, task)["error"]).toBe("chi.MoveTo_ask.port.abort or chi.Say.port.error");
  const skipped = after(failing, setDisabled(failing, say ?? "", true, supplies)).tree;
  expect(conditions(skipped, task)["success"]).toBe("chi.MoveTo.port.success or chi.MoveTo_ask.port.skip");
  expect(lineOf(skipped, task).steps.map(({ disabled }) => disabled)).toEqual([false, true]);
});

test("a task with all steps off ends at once, and well", () => {
  const { tree, task, steps: [wait] } = appOf("Wait");
  const off = after(tree, setDisabled(tree, wait ?? "", true, supplies)).tree;
  expect([elementOf(off, task).fields["first"], conditions(off, task)]).toEqual([undefined, { success: "True", error: "False" }]);
  expect(lineOf(off, task).form).toBe("editable");
});

test("an outcome that goes on at the end of a task goes on when a step follows", () => {
  const { tree, task, steps: [ask] } = appOf("AskYesNo");
  expect(lineOf(tree, task).steps[0]?.outcomes).toMatchObject([{ port: { name: "no" }, goes: "end" }]);
  const on = after(tree, setOutcome(tree, ask ?? "", "no", "next", supplies)).tree;
  const more = after(on, addSkill(on, task, 1, { document: "skills", id: stateNamed(skills.tree, "Wait") }, supplies)).tree;
  expect(targets(more, ask ?? "")).toMatchObject({ yes: "Wait", no: "Wait" });
});

test("what is found is taken from the nearest step before, and a step that gives it to another one stays before that", () => {
  const { tree, task, steps: [first, second, pick] } = appOf("FindPart", "FindPart", "PickPart");
  const from = (of: Tree) => lineOf(of, task).steps.find(({ id }) => id === pick)?.parameters[0]?.value;
  expect(from(tree)).toEqual({ kind: "taken", source: { step: second, result: "part" } });
  const chosen = after(tree, setSource(tree, pick ?? "", "part", { step: first ?? "", result: "part" }, supplies)).tree;
  expect(from(chosen)).toEqual({ kind: "taken", source: { step: first, result: "part" } });
  expect(sourcesOf(tree, lineOf(tree, task).steps, pick ?? "", "found").map(({ step }) => step)).toEqual([second, first]);
  const takes = '"Pick a part" takes what "Find a part" gives';
  const other = 'or choose another "Part" there';
  expect(reasonOf(removeStep(chosen, first ?? "", supplies))).toBe(`${takes}: remove "Pick a part" first, ${other}`);
  expect(reasonOf(moveStep(chosen, first ?? "", task, 2, supplies))).toBe(`${takes}: "Find a part" has to stand before it, in the same task or loop as "Pick a part", ${other}`);
  for (const group of [[first], [second, pick]]) expect(reasonOf(loopSteps(chosen, group.map((id) => id ?? ""), 2, supplies))).toBe(`${takes}: repeat both, ${other}`);
  expect(from(after(chosen, loopSteps(chosen, [second ?? ""], 2, supplies)).tree)).toEqual({ kind: "taken", source: { step: first, result: "part" } });
  expect(from(after(chosen, removeStep(chosen, second ?? "", supplies)).tree)).toEqual({ kind: "taken", source: { step: first, result: "part" } });
  const none = after(chosen, moveStep(chosen, pick ?? "", task, 0, supplies)).tree;
  expect(from(none)).toMatchObject({ kind: "missing" });
  expect(problemsOf(none, lineOf(none, task), [{ key: "gripper", type: "gripper", available: true }, { key: "obj_rec", type: "ObjectRecognition", available: true }])).toEqual([{ step: pick, parameter: "part", text: "no step before it finds a part" }]);
  const alone = after(none, removeStep(none, first ?? "", supplies)).tree;
  expect(from(after(alone, moveStep(alone, second ?? "", task, 0, supplies)).tree)).toEqual({ kind: "taken", source: { step: second, result: "part" } });
});

test("problems are a service that is not there, a value that is not set, and a source that is off", () => {
  const { tree, task, steps: [find] } = appOf("FindPart", "PickPart", "MoveTo");
  const off = after(tree, setDisabled(tree, find ?? "", true, supplies)).tree;
  expect(problemsOf(off, lineOf(off, task), ["db", "robot"].map((key) => ({ key, type: key, available: true }))).map(({ text }) => text)).toEqual(["the gripper is not there", "the step that finds its part is off", '"Place" is not set']);
});

test("a title is what people read; the name of the state stays, and a question to a person has the title", () => {
  const { tree, task, steps: [say] } = appOf("Say");
  const named = after(tree, renameStep(tree, say ?? "", " Greet ", supplies)).tree;
  expect(lineOf(named, task).steps[0]).toMatchObject({ name: "Say", title: "Greet" });
  expect(reasonOf(renameStep(tree, say ?? "", "", supplies))).toBe("a name needs a letter");
  expect(reasonOf(renameStep(tree, say ?? "", "x".repeat(41), supplies))).toBe("a name has at most 40 characters");
  expect([nameFor("Müll & Co", "Task"), nameFor("2 parts", "Task"), nameFor("!", "Task")]).toEqual(["MullCo", "Task", "Task"]);
});

test("what cannot be done says why", () => {
  const { tree, task, steps: [wait, say] } = appOf("Wait", "Say");
  expect(reasonOf(setFailure(tree, wait ?? "", { kind: "ask" }, supplies))).toBe("it cannot fail");
  expect(reasonOf(moveStep(tree, task, task, 0, supplies))).toBe("it cannot be moved into itself");
  expect(reasonOf(moveStep(tree, say ?? "", task, 1, supplies))).toBe("it stands there already");
  expect(reasonOf(setFailure(tree, say ?? "", { kind: "ask" }, { ...supplies, documents: [] }))).toBe('no document on the server has what "ask a person" is made of');
});

test("numbers are written as they were typed", () => {
  const { tree, steps: [wait] } = appOf("Wait");
  const command = setValue(tree, wait ?? "", "seconds", readExact("2.50"), supplies);
  expect("change" in command && writeExact(command.change)).toContain('"value":2.50');
});

const demonstrator = treeOf(readJson(new URL("../../../deploy/demo/demonstrator.rcm.json", import.meta.url)) as JsonValue);

test("the demonstrator is two tasks to be read (thesis, Fig. A.3)", () => {
  const { tasks, isEditable } = readApplication(demonstrator);
  expect(isEditable).toBe(false);
  expect(tasks.map(({ title, inner }) => [title, inner?.form])).toEqual([["Calibrate the camera", "rich"], ["Clear the table", "rich"]]);
  expect(tasks[1]?.inner?.steps.map(({ title }) => title)).toEqual(["Take out", "Aside", "Place area", "Say", "Search a part, with gestures", "Work"]);
  expect(tasks[1]?.inner?.again).toBe(tasks[1]?.inner?.steps[1]?.id);
  expect(reasonOf(removeStep(demonstrator, tasks[1]?.inner?.steps[4]?.id ?? "", supplies))).toContain("only be changed in RACE Pro");
});

test("a constant is followed to where it stands, and set there", () => {
  const table = readApplication(demonstrator).tasks[1];
  const search = table?.inner?.steps[4];
  const labels = search?.parameters.find(({ about }) => about.name === "labels")?.value;
  expect(labels).toMatchObject({ kind: "constant", state: table?.id, name: "labels", value: ["Cube", "Box", "Block", "Tape", "Bar"] });
  expect(search?.parameters.find(({ about }) => about.name === "but")?.value).toEqual({ kind: "computed", state: search?.id, text: "res.skipped" });
  expect(search?.parameters.find(({ about }) => about.name === "pictures")?.value).toMatchObject({ kind: "constant", state: search?.id, value: 15 });
  const { tree } = after(demonstrator, setValue(demonstrator, search?.id ?? "", "labels", ["Tape"], supplies));
  expect(readApplication(tree).tasks[1]?.parameters.find(({ about }) => about.name === "labels")?.value).toMatchObject({ value: ["Tape"] });
  const own = after(demonstrator, setValue(demonstrator, search?.id ?? "", "timeout", readExact("7.0"), supplies)).tree;
  expect(readApplication(own).tasks[1]?.inner?.steps[4]?.parameters.find(({ about }) => about.name === "timeout")?.value).toMatchObject({ kind: "constant", state: search?.id, value: 7 });
  expect(reasonOf(setValue(demonstrator, search?.id ?? "", "but", [], supplies))).toBe("it is computed: only RACE Pro can change it");
});

test("a root whose children are no tasks is the one task; what has no flow is a list", () => {
  const pick = treeOf(readJson(new URL("../../../deploy/demo/pick.rcm.json", import.meta.url)) as JsonValue);
  expect(readApplication(pick).tasks.map(({ title, inner }) => [title, inner?.form, inner?.steps.length])).toEqual([["Pick", "rich", 6]]);
  const list = treeOf({ rcm: 1, root: { state: "R", meta: { id: "r" }, children: [{ state: "A", entry: "pass", meta: { id: "a" } }] } });
  expect(readApplication(list).tasks[0]?.inner).toMatchObject({ form: "list", steps: [], others: [{ title: "A" }] });
});

const kOrder = "its steps are not simply done one after the other";

test.each<[string, string, (tree: Tree, task: string, steps: readonly string[]) => Operation]>([
  ["a step that leads elsewhere", kOrder, (tree, _, [first]) => ({ op: "set", id: listOf(tree, first ?? "", "ports")[0] ?? "", field: "to", value: "Say2" })],
  ["an error that leads elsewhere than the others", kOrder, (tree, _, [first]) => ({ op: "set", id: listOf(tree, first ?? "", "ports")[1] ?? "", field: "to", value: "Say" })],
  ["another condition", kOrder, (tree, task) => ({ op: "set", id: listOf(tree, task, "ports")[0] ?? "", field: "when", value: "chi.Say.active" })],
  ["another first step", kOrder, (_, task) => ({ op: "set", id: task, field: "first", value: "Say" })],
  ["an exit", "“My task” does something of its own when it ends", (_, task) => ({ op: "set", id: task, field: "exit", value: "pass" })],
  ["an action", "“My task” does something of its own while its steps are done", (_, task) => ({ op: "insert", parent: task, list: "actions", node: { when: "False", do: "pass", meta: { id: "act" } } })],
  ["a memory", "“My task” remembers from one time to the next where it was", (_, task) => ({ op: "set", id: task, field: "keep", value: true })],
  ["a skill that is gone", "what “X” does is missing in this application", (_, task) => ({ op: "insert", parent: task, list: "children", node: { state: "X", link: "Nothing", meta: { id: "x" } } })],
  ["an entry", "“My task” does something of its own when it begins", (_, task) => ({ op: "set", id: task, field: "entry", value: "pass" })],
  ["an oracle", "“My task” chooses with which step it begins only while it runs", (_, task) => ({ op: "set", id: task, field: "oracle", value: { kind: "expr", expr: "'Say'" } })],
  ["a third port", "it can also end in another way, “Odd”", (_, task) => ({ op: "insert", parent: task, list: "ports", node: { name: "odd", when: "False", meta: { id: "odd" } } })],
  ["a barrier", "several of its steps are done at the same time", (_, task) => ({ op: "insert", parent: task, list: "children", node: { barrier: "B", to: ["Say"], meta: { id: "bar" } } })],
  ["a state with code", "“X” does something of its own when it begins", (_, task) => ({ op: "insert", parent: task, list: "children", node: { state: "X", entry: "pass", meta: { id: "x" } } })],
  ["a link to what is no skill", "“X” is no skill of the library", (_, task) => ({ op: "insert", parent: task, list: "children", node: { state: "X", link: "GetPose", meta: { id: "x" } } })],
  ["a disabled step that is led to", kOrder, (_, __, [, second]) => ({ op: "set", id: second ?? "", field: "meta", key: "disabled", value: true })],
])("a task with %s is only read, as %s", (_, reason, change) => {
  const { tree, task, steps } = appOf("MoveTo", "Say", "Say");
  expect(lineOf(tree, task).form).toBe("editable");
  const applied = apply(tree, { operations: [change(tree, task, steps)] });
  if (applied instanceof Refusal) throw applied;
  expect(lineOf(applied.tree, task)).toMatchObject({ form: "rich", reason });
});

test("a step that gets another name in RACE Pro stays a step", () => {
  const { tree, task, steps: [move] } = appOf("MoveTo", "Say");
  const failing = after(tree, setFailure(tree, move ?? "", { kind: "retry", then: "ask" }, supplies)).tree;
  const renamed = apply(failing, {
    operations: [
      { op: "set", id: move ?? "", field: "state", value: "Go" }, { op: "set", id: task, field: "first", value: "Go" },
      ...listOf(failing, task, "children").slice(2).flatMap((id): readonly Operation[] => listOf(failing, id, "ports").filter((port) => elementOf(failing, port).fields["to"] === "MoveTo").map((port) => ({ op: "set", id: port, field: "to", value: "Go" }))),
    ],
  });
  if (renamed instanceof Refusal) throw renamed;
  expect(lineOf(renamed.tree, task)).toMatchObject({ form: "editable", steps: [{ name: "Go", failure: { kind: "retry", then: "ask" } }, { name: "Say" }] });
});
