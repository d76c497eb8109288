// A loop ends when one of its steps says so (api/skills.md).
import { expect, test } from "vitest";
import { apply, type Operation } from "../../shared/edit/apply";
import type { Command } from "../../shared/edit/commands/command";
import { nameOfElement } from "../../shared/edit/commands/command";
import { Refusal } from "../../shared/edit/refusal";
import { elementOf, listOf, type Tree } from "../../shared/edit/tree";
import { addSkill, addTask } from "../../shared/timeline/changes/add";
import { setFailure, setOutcome } from "../../shared/timeline/changes/failure";
import { loopSteps, repeatUntil, unloop } from "../../shared/timeline/changes/loop";
import { moveStep, removeStep, setDisabled } from "../../shared/timeline/changes/steps";
import { setValue } from "../../shared/timeline/changes/values";
import { readApplication } from "../../shared/timeline/read";
import { allSteps, type Step } from "../../shared/timeline/timeLine";
import { repeatText } from "../../one/line/repeatText";
import { endsOf } from "../../shared/timeline/until";
import { documentText } from "../edit/documents";
import { emptyApp, skills, stateNamed } from "../skills/fixture";
import { after, supplies } from "./after";

/** A task in which a search and a text are repeated three times, and a text follows. */
function looped(): { readonly tree: Tree; readonly task: string; readonly loop: string; readonly find: string; readonly say: string } {
  const made = after(emptyApp, addTask(emptyApp, "root", 0, "My task", supplies));
  let { tree } = made;
  const [find = "", say = ""] = ["FindPart", "Say", "Say"].map((name, i) => {
    const next = after(tree, addSkill(tree, made.id, i, { document: "skills", id: stateNamed(skills.tree, name) }, supplies));
    tree = next.tree;
    return next.id;
  });
  const loop = after(tree, loopSteps(tree, [find, say], 3, supplies));
  return { tree: loop.tree, task: made.id, loop: loop.id, find, say };
}

const stepOf = (tree: Tree, id: string): Step => {
  const found = allSteps(readApplication(tree).root).find((step) => step.id === id);
  if (found === undefined) throw new Error(`there is no ${id}`);
  return found;
};
const conditions = (tree: Tree, id: string) => Object.fromEntries(listOf(tree, id, "ports").map((port) => [nameOfElement(tree, port), elementOf(tree, port).fields["when"]]));
const bodyOf = (tree: Tree, loop: string): string => listOf(tree, loop, "children")[0] ?? "";
const untilNone = (tree: Tree, { loop, find }: { readonly loop: string; readonly find: string }, isEnd = true) => repeatUntil(tree, loop, { step: find, port: "none" }, isEnd, supplies);
const reasonOf = (command: Command) => ("reason" in command ? command.reason : undefined);

test("what the steps of a loop can say is offered, and the loop says how it repeats", () => {
  const made = looped();
  expect(endsOf(stepOf(made.tree, made.loop)).map(({ step, port, title, isChosen }) => [step.id, port, title, isChosen])).toEqual([[made.find, "none", "There is no part", false]]);
  expect(repeatText(stepOf(made.tree, made.loop))).toBe("3 ×");
  const { tree } = after(made.tree, untilNone(made.tree, made));
  expect(endsOf(stepOf(tree, made.loop)).map(({ isChosen }) => isChosen)).toEqual([true]);
  expect(repeatText(stepOf(tree, made.loop))).toBe("until “There is no part”");
  expect(repeatText(stepOf(after(tree, setFailure(tree, made.say, { kind: "leave" }, supplies)).tree, made.loop))).toBe("until “There is no part”, or until “Show a text” fails");
});

test("the loop is left by a port of what it repeats, and that port goes again when nothing leaves", () => {
  const made = looped();
  const { tree } = after(made.tree, untilNone(made.tree, made));
  const body = bodyOf(tree, made.loop);
  expect(conditions(tree, body)).toEqual({ success: "chi.Say.port.success", error: "chi.FindPart.port.error or chi.Say.port.error", done: "chi.FindPart.port.none" });
  expect(conditions(tree, made.loop)).toEqual({ success: "chi.Count.port.done or chi.Body.port.done", error: "chi.Body.port.error" });
  expect(stepOf(tree, made.loop).repeat?.value).toMatchObject({ value: 0 });
  const failing = after(tree, setFailure(tree, made.say, { kind: "retry", then: "leave" }, supplies)).tree;
  expect(conditions(failing, body)["done"]).toBe("chi.FindPart.port.none or chi.Say_retry.port.give_up");
  expect(stepOf(failing, made.say).failure).toEqual({ kind: "retry", then: "leave" });
  const back = after(tree, untilNone(tree, made, false)).tree;
  expect(conditions(back, body)["done"]).toBeUndefined();
  expect(stepOf(back, made.loop).repeat?.value).toMatchObject({ value: 3 });
  expect(documentText(back)).toBe(documentText(made.tree));
});

test("a step that is off keeps what it was to end", () => {
  const made = looped();
  const { tree } = after(made.tree, untilNone(made.tree, made));
  const off = after(tree, setDisabled(tree, made.find, true, supplies)).tree;
  expect(stepOf(off, made.find).outcomes).toMatchObject([{ port: { name: "none" }, goes: "leave" }]);
  const on = after(off, setDisabled(off, made.find, false, supplies)).tree;
  expect(repeatText(stepOf(on, made.loop))).toBe("3 ×, or until “There is no part”");
});

const byOutcome = (tree: Tree, { find }: { readonly find: string }) => setOutcome(tree, find, "none", "leave", supplies);
const byFailure = (tree: Tree, { say }: { readonly say: string }) => setFailure(tree, say, { kind: "leave" }, supplies);
const byRetry = (tree: Tree, { say }: { readonly say: string }) => setFailure(tree, say, { kind: "retry", then: "leave" }, supplies);

type Made = ReturnType<typeof looped>;
test.each<[string, (tree: Tree, made: Made) => Command, (tree: Tree, made: Made) => Command]>([
  ["its choice is taken back", untilNone, (tree, made) => untilNone(tree, made, false)],
  ["its outcome goes on", byOutcome, (tree, { find }) => setOutcome(tree, find, "none", "next", supplies)],
  ["its failure stops the task", byFailure, (tree, { say }) => setFailure(tree, say, { kind: "stop" }, supplies)],
  ["it asks after it was tried again", byRetry, (tree, { say }) => setFailure(tree, say, { kind: "retry", then: "ask" }, supplies)],
  ["it is removed", byFailure, (tree, { say }) => removeStep(tree, say, supplies)],
  ["it is turned off", byOutcome, (tree, { find }) => setDisabled(tree, find, true, supplies)],
  ["it is moved out of the loop", byOutcome, (tree, { find, task }) => moveStep(tree, find, task, 0, supplies)],
])("a loop that repeated until a step says so is counted when %s", (_, end, noMore) => {
  const made = looped();
  const ended = after(made.tree, end(made.tree, made)).tree;
  for (const times of [0, 7]) {
    const count = listOf(ended, made.loop, "children")[1] ?? "";
    const tree = after(ended, setValue(ended, count, "times", times, supplies)).tree;
    const text = repeatText(stepOf(tree, made.loop));
    expect([text.includes("until"), text.includes("7 ×")]).toEqual([true, times === 7]);
    expect(repeatText(stepOf(after(tree, noMore(tree, made)).tree, made.loop))).toBe(times === 0 ? "3 ×" : "7 ×");
  }
});

test("a loop that another step still ends stays uncounted, and one that a person lets repeat for ever, too", () => {
  const made = looped();
  const one = after(made.tree, untilNone(made.tree, made)).tree;
  const two = after(one, setFailure(one, made.say, { kind: "leave" }, supplies)).tree;
  expect(repeatText(stepOf(after(two, removeStep(two, made.say, supplies)).tree, made.loop))).toBe("until “There is no part”");
  const forEver = after(made.tree, setValue(made.tree, listOf(made.tree, made.loop, "children")[1] ?? "", "times", 0, supplies)).tree;
  expect(repeatText(stepOf(after(forEver, removeStep(forEver, made.say, supplies)).tree, made.loop))).toBe("for ever");
});

test("without its loop a step does what a new one does; the loop goes on without it", () => {
  const made = looped();
  const { tree } = after(made.tree, untilNone(made.tree, made));
  const apart = after(tree, unloop(tree, made.loop, supplies)).tree;
  const moved = after(tree, moveStep(tree, made.find, made.task, 0, supplies)).tree;
  for (const each of [apart, moved]) expect(stepOf(each, made.find).outcomes).toMatchObject([{ goes: "end" }]);
  for (const each of [moved, after(tree, removeStep(tree, made.find, supplies)).tree]) {
    expect(conditions(each, made.loop)["success"]).toBe("chi.Count.port.done");
    expect(conditions(each, bodyOf(each, made.loop))["done"]).toBeUndefined();
  }
});

test("a step ends no other loop than the one that repeats it, and none where there is none", () => {
  const made = looped();
  const { tree } = after(made.tree, untilNone(made.tree, made));
  expect(reasonOf(loopSteps(tree, [made.find], 2, supplies))).toBe('"Find a part" ends the loop around it: let it do something else first');
  const apart = after(made.tree, unloop(made.tree, made.loop, supplies)).tree;
  const nowhere = "it stands in no loop that it could end";
  expect([setOutcome(apart, made.find, "none", "leave", supplies), setFailure(apart, made.say, { kind: "retry", then: "leave" }, supplies)].map(reasonOf)).toEqual([nowhere, nowhere]);
  expect(reasonOf(repeatUntil(tree, made.loop, { step: made.say, port: "none" }, true, supplies))).toBe("it has no such outcome");
});

test("what ended a loop does not end the loop around that one, when it is taken apart", () => {
  const made = looped();
  const outer = after(made.tree, loopSteps(made.tree, [made.loop], 2, supplies));
  const { tree } = after(outer.tree, untilNone(outer.tree, made));
  const apart = after(tree, unloop(tree, made.loop, supplies)).tree;
  expect(stepOf(apart, made.find).outcomes).toMatchObject([{ goes: "end" }]);
  expect(conditions(apart, outer.id)["success"]).toBe("chi.Count.port.done");
});

test.each<[string, (tree: Tree, body: string, loop: string) => Operation]>([
  ["does not end when its step says so", (tree, _, loop) => ({ op: "set", id: listOf(tree, loop, "ports")[0] ?? "", field: "when", value: "chi.Count.port.done" })],
  ["goes on when its step says so", (tree, body) => ({ op: "set", id: listOf(tree, body, "ports")[2] ?? "", field: "to", value: "Count" })],
  ["ends by something else, too", (tree, _, loop) => ({ op: "set", id: listOf(tree, loop, "ports")[0] ?? "", field: "when", value: "chi.Count.port.done or chi.Body.port.done or chi.Body.port.error" })],
])("a loop that %s is only read", (_, change) => {
  const made = looped();
  const { tree } = after(made.tree, untilNone(made.tree, made));
  const applied = apply(tree, { operations: [change(tree, bodyOf(tree, made.loop), made.loop)] });
  if (applied instanceof Refusal) throw applied;
  expect(stepOf(applied.tree, made.loop).repeat).toBeUndefined();
});
