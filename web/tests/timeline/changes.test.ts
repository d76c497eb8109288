// Any sequence of changes leaves the time lines that were meant, in the form of api/skills.md.
import { expect, test } from "vitest";
import { apply } from "../../shared/edit/apply";
import { Refusal } from "../../shared/edit/refusal";
import { elementOf, listOf, type Tree } from "../../shared/edit/tree";
import { nameOfElement } from "../../shared/edit/commands/command";
import { readApplication } from "../../shared/timeline/read";
import { allSteps } from "../../shared/timeline/timeLine";
import { documentText } from "../edit/documents";
import { randomOf, setting } from "../edit/random";
import { shapeOf, RandomTask } from "./randomChanges";

const seed = setting("RACE_SEED", Date.now() % 1_000_000);
const kSeeds = 8;
const kChanges = 60;

/** What is taken from a sibling is taken from one that stands before. */
function checkSources(tree: Tree): void {
  for (const step of allSteps(readApplication(tree).root))
    for (const { value } of step.parameters) {
      if (step.kind === "skill") expect(value.kind).not.toBe("computed");
      if (value.kind !== "taken") continue;
      const siblings = listOf(tree, elementOf(tree, step.id).parent, "children");
      expect(siblings).toContain(value.source.step);
      expect(siblings.indexOf(value.source.step)).toBeLessThan(siblings.indexOf(step.id));
    }
}

/** Names of siblings are different, and what leads somewhere leads to one of them. */
function checkNames(tree: Tree): void {
  for (const { id, kind } of tree.elements.values()) {
    if (kind !== "state") continue;
    const names = listOf(tree, id, "children").map((child) => nameOfElement(tree, child));
    expect(new Set(names).size).toBe(names.length);
    for (const child of listOf(tree, id, "children"))
      for (const port of listOf(tree, child, "ports")) {
        const { to } = elementOf(tree, port).fields;
        if (to !== undefined) expect(names).toContain(to);
      }
  }
}

test("any sequence of changes reads back as what was meant, and can be undone", () => {
  for (let i = 0; i < kSeeds; ++i) {
    const task = new RandomTask(randomOf(seed + i));
    for (let n = 0; n < kChanges; ++n) {
      const before = task.tree;
      const what = task.change();
      const context = `seed ${seed + i}, change ${n}: ${what}`;
      if (task.tree === before) continue;
      expect(shapeOf(readApplication(task.tree).root), context).toEqual(task.expected);
      checkSources(task.tree);
      checkNames(task.tree);
      const there = apply(before, { operations: task.operations });
      if (there instanceof Refusal) throw there;
      const back = apply(there.tree, there.inverse);
      if (back instanceof Refusal) throw back;
      expect(documentText(back.tree), context).toBe(documentText(before));
    }
  }
});
