// The guide makes its application by changes, one after the other: a second try goes on where the first one has ended, and makes nothing twice.
import { expect, test } from "vitest";
import { elementOf } from "../../shared/edit/tree";
import type { Tree } from "../../shared/edit/tree";
import { setValue } from "../../shared/timeline/changes/values";
import { removeStep } from "../../shared/timeline/changes/steps";
import { readApplication } from "../../shared/timeline/read";
import { isMade, nextChange, type WantedSkill } from "../../one/guide/wanted";
import { emptyApp, skills, stateNamed } from "../skills/fixture";
import { after, supplies } from "../timeline/after";

const kWanted: readonly WantedSkill[] = [
  { skill: "MoveTo", values: { pose: "part1" } },
  { skill: "MoveTo", values: { pose: "place1" } },
];
const places = kWanted.map(({ skill }) => ({ document: "skills", id: stateNamed(skills.tree, skill) }));

/** After so many more changes; all of them, if there are fewer. */
function goOn(from: Tree, changes: number): Tree {
  let tree = from;
  for (let n = 0; n < changes; n++) {
    const next = nextChange(tree, "Move a part", kWanted, places, supplies);
    if (next === undefined) return tree;
    tree = after(tree, next).tree;
  }
  return tree;
}

/** The titles of tasks, and the poses of their steps. */
const shape = (tree: Tree) =>
  readApplication(tree).tasks.map(({ title, inner }) => [title, inner?.steps.map(({ parameters }) => parameters.flatMap(({ about, value }) => (about.name === "pose" && value.kind === "constant" ? [value.value] : [])))]);

const kMade = [["Move a part", [["part1"], ["place1"]]]];

test.each([0, 1, 2, 3, 4, 5])("a try that ended after %i changes is gone on with", (changes) => {
  const partly = goOn(emptyApp, changes);
  expect(isMade(partly, kWanted)).toBe(changes === 5);
  const made = goOn(partly, 20);
  expect(shape(made)).toEqual(kMade);
  expect(isMade(made, kWanted)).toBe(true);
  expect(nextChange(made, "Move a part", kWanted, places, supplies)).toBeUndefined();
});

test("a step that the server has refused is made again in its place", () => {
  const made = goOn(emptyApp, 20);
  const [, last] = readApplication(made).tasks[0]?.inner?.steps ?? [];
  const without = after(made, removeStep(made, last?.id ?? "", supplies)).tree;
  expect(isMade(without, kWanted)).toBe(false);
  expect(shape(goOn(without, 20))).toEqual(kMade);
});

test("what a person has changed meanwhile stays as it is", () => {
  const made = goOn(emptyApp, 20);
  const [first] = readApplication(made).tasks[0]?.inner?.steps ?? [];
  const changed = after(made, setValue(made, first?.id ?? "", "pose", "home", supplies)).tree;
  expect(elementOf(changed, first?.id ?? "").kind).toBe("state");
  expect(isMade(changed, kWanted)).toBe(true);
});
