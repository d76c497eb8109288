// A change of a time line changes nothing of where the other steps take their values from; a change that would is refused.
import { expect, test } from "vitest";
import { apply } from "../../shared/edit/apply";
import { nameOfElement } from "../../shared/edit/commands/command";
import { Refusal } from "../../shared/edit/refusal";
import { elementOf, listOf, subtree, type Tree } from "../../shared/edit/tree";
import { skillsIn } from "../../shared/skills/skill";
import { addSkill, addTask } from "../../shared/timeline/changes/add";
import { loopSteps, unloop } from "../../shared/timeline/changes/loop";
import { moveStep, removeStep } from "../../shared/timeline/changes/steps";
import type { Command } from "../../shared/edit/commands/command";
import { randomOf, setting } from "../edit/random";
import { emptyApp, skills, stateNamed } from "../skills/fixture";
import { after, supplies } from "./after";
import { RandomTask } from "./randomChanges";

const seed = setting("RACE_SEED", Date.now() % 1_000_000);
const kSeeds = 12;
const kChanges = 60;
const kGivingAndTaking = skillsIn(skills.tree).filter(({ name }) => name === "FindPart" || name === "PickPart");

/** What each link says of its parameters, read from the document alone: `ID.part` is `step ID` with the id of the step that gives it, or a constant. */
function originsOf(tree: Tree): ReadonlyMap<string, string> {
  const origins = new Map<string, string>();
  for (const id of subtree(tree, tree.root)) {
    const { kind, fields, parent } = elementOf(tree, id);
    if (kind !== "state" || typeof fields["link"] !== "string" || fields["link"].startsWith("WhatNow")) continue;
    const siblings = listOf(tree, parent, "children");
    for (const parameter of listOf(tree, id, "parameters")) {
      const { from, value } = elementOf(tree, parameter).fields;
      const [, name = ""] = /^chi\.(\w+)\.res\.part$/.exec(typeof from === "string" ? from : "") ?? [];
      const giver = siblings.find((sibling) => nameOfElement(tree, sibling) === name);
      origins.set(`${id}.${nameOfElement(tree, parameter)}`, from === undefined ? JSON.stringify(value) : `step ${giver}`);
    }
  }
  return origins;
}

test("after any change, each step that it does not name takes each of its values from the same step as before; a loop that nothing ends any more is counted", () => {
  let [kept, refused, settled] = [0, 0, 0];
  for (let i = 0; i < kSeeds; ++i) {
    const task = new RandomTask(randomOf(seed + i), kGivingAndTaking);
    for (let n = 0; n < kChanges; ++n) {
      const before = task.tree;
      const context = `seed ${seed + i}, change ${n}: ${task.change()}`;
      if (task.tree === before) {
        refused += Number(context.endsWith("refused"));
        continue;
      }
      const [were, are] = [originsOf(before), originsOf(task.tree)];
      for (const [parameter, origin] of were) {
        const [state = ""] = parameter.split(".");
        if (!task.tree.elements.has(state) || task.named.includes(state)) continue;
        if (parameter.endsWith(".times") && task.counts.includes(state)) {
          expect([origin, are.get(parameter)], context).toEqual(["0", "3"]);
          settled++;
          continue;
        }
        expect([parameter, are.get(parameter)], context).toEqual([parameter, origin]);
        kept += Number(origin.startsWith("step"));
      }
      for (const [parameter, origin] of are) {
        const [state = ""] = parameter.split(".");
        if (were.has(parameter) || !before.elements.has(state)) continue;
        expect([state, origin.replace("step ", "")].some((id) => task.named.includes(id)), `${context}: ${parameter} takes ${origin}`).toBe(true);
      }
    }
  }
  expect(kept).toBeGreaterThan(50);
  expect(refused).toBeGreaterThan(0);
  expect(settled).toBeGreaterThan(0);
});

const placeOf = (name: string) => ({ document: "skills", id: stateNamed(skills.tree, name) });

/** A task with a parameter `fast`, of two steps that move; that at `index` has its speed by `from`. */
function taskWith(from: string, index: number): { readonly tree: Tree; readonly task: string; readonly steps: readonly [string, string] } {
  const made = after(emptyApp, addTask(emptyApp, "root", 0, "My task", supplies));
  const one = after(made.tree, addSkill(made.tree, made.id, 0, placeOf("MoveTo"), supplies));
  const two = after(one.tree, addSkill(one.tree, made.id, 1, placeOf("MoveTo"), supplies));
  const applied = apply(two.tree, {
    operations: [
      { op: "insert", parent: made.id, list: "parameters", node: { name: "fast", value: 0.9, meta: { id: "fast" } } },
      { op: "insert", parent: index === 0 ? one.id : two.id, list: "parameters", node: { name: "speed", from, meta: { id: "own" } } },
    ],
  });
  if (applied instanceof Refusal) throw applied;
  return { tree: applied.tree, task: made.id, steps: [one.id, two.id] };
}

const kComputed = { reason: 'the "Speed" of "Move to" is computed from what is around it: change this in RACE Pro' };
const isDone = (command: Command): boolean => "change" in command;

test.each(["par.fast", "par.fast / 2"])("a step with the value `%s` of its task stays in the task", (from) => {
  const { tree, task, steps: [first, second] } = taskWith(from, 0);
  const { tree: two, id: another } = after(tree, addTask(tree, "root", 1, "Another", supplies));
  expect(loopSteps(tree, [first], 2, supplies)).toEqual(kComputed);
  expect(moveStep(two, first, another, 0, supplies)).toEqual(kComputed);
  expect([moveStep(tree, first, task, 1, supplies), loopSteps(tree, [second], 2, supplies), moveStep(two, second, another, 0, supplies)].every(isDone)).toBe(true);
});

test("a value that is computed from another step keeps that step beside its own", () => {
  const { tree, task, steps: [first, second] } = taskWith("chi.MoveTo.res.part['speed']", 1);
  expect([loopSteps(tree, [first], 2, supplies), loopSteps(tree, [second], 2, supplies), removeStep(tree, first, supplies)]).toEqual([kComputed, kComputed, kComputed]);
  expect([loopSteps(tree, [first, second], 2, supplies), removeStep(tree, second, supplies), moveStep(tree, second, task, 0, supplies)].every(isDone)).toBe(true);
});

test("a value that is computed from nothing else goes wherever its step goes", () => {
  const { tree, steps } = taskWith("0.1 + 0.2", 0);
  const looped = after(tree, loopSteps(tree, steps, 2, supplies));
  const back = after(looped.tree, unloop(looped.tree, looped.id, supplies)).tree;
  expect(elementOf(back, "own")).toMatchObject({ parent: steps[0], fields: { from: "0.1 + 0.2" } });
});

test("a value that is missing comes from a step that is new in its place, and from no other", () => {
  const made = after(emptyApp, addTask(emptyApp, "root", 0, "My task", supplies));
  const find = after(made.tree, addSkill(made.tree, made.id, 0, placeOf("FindPart"), supplies));
  const pick = after(find.tree, addSkill(find.tree, made.id, 1, placeOf("PickPart"), supplies));
  const [own = ""] = listOf(pick.tree, pick.id, "parameters");
  const applied = apply(pick.tree, { operations: [{ op: "remove", id: own }] });
  if (applied instanceof Refusal) throw applied;
  const wait = after(applied.tree, addSkill(applied.tree, made.id, 1, placeOf("Wait"), supplies));
  expect(originsOf(wait.tree).get(`${pick.id}.part`)).toBeUndefined();
  const another = after(wait.tree, addSkill(wait.tree, made.id, 2, placeOf("FindPart"), supplies));
  expect(originsOf(another.tree).get(`${pick.id}.part`)).toBe(`step ${another.id}`);
});
