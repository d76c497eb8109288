// Buttons that answer a question about a failure are called as the model calls the ports that they lead to.
import { expect, test } from "vitest";
import type { Tree } from "../../shared/edit/tree";
import { addSkill, addTask } from "../../shared/timeline/changes/add";
import { setFailure } from "../../shared/timeline/changes/failure";
import { answerTitles, buttonTitles, titlesAsked } from "../../shared/timeline/answers";
import { readApplication } from "../../shared/timeline/read";
import { allSteps } from "../../shared/timeline/timeLine";
import { documentOf } from "../../shared/edit/tree";
import type { JsonValue } from "../../shared/json";
import { treeOf } from "../edit/documents";
import { readJson } from "../files";
import { emptyApp, skills, stateNamed } from "../skills/fixture";
import { after, supplies } from "./after";

/** A step that asks a person if it fails, and what asks. */
function asking(): { readonly tree: Tree; readonly step: string; readonly ask: string } {
  const task = after(emptyApp, addTask(emptyApp, "root", 0, "My task", supplies));
  const move = after(task.tree, addSkill(task.tree, task.id, 0, { document: "skills", id: stateNamed(skills.tree, "MoveTo") }, supplies));
  const { tree } = after(move.tree, setFailure(move.tree, move.id, { kind: "ask" }, supplies));
  const ask = allSteps(readApplication(tree).root).find(({ id }) => id === move.id)?.handlers[0] ?? "";
  return { tree, step: move.id, ask };
}

const kButtons = ["Try again", "Skip", "Stop"];

test("a button is called by the title of its port; one whose port has none keeps its own name", () => {
  const { tree, ask } = asking();
  const titles = titlesAsked(tree, readApplication(tree).root, new Set([ask]));
  expect(buttonTitles(kButtons, titles)).toEqual(["Try again", "Go on without it", "Stop"]);
});

test("a question of a step that has not failed keeps its buttons", () => {
  const { tree, step } = asking();
  expect(buttonTitles(kButtons, titlesAsked(tree, readApplication(tree).root, new Set([step])))).toEqual(kButtons);
});

test("the question of the demo is answered by the words of its model", () => {
  const demo = treeOf(readJson(new URL("../../../deploy/demo/skills.rcm.json", import.meta.url)) as JsonValue);
  const titles = answerTitles(demo, stateNamed(demo, "WhatNow"));
  expect(buttonTitles(["Retry", "Skip", "Abort"], titles)).toEqual(["Try again", "Go on with the next step", "Stop the task"]);
});

test("a title that a document gives itself comes first, and two that are equal tell nothing apart", () => {
  const { tree, ask } = asking();
  const renamed = JSON.stringify(documentOf(tree)).replaceAll("Go on without it", "Leave it");
  const own = treeOf(JSON.parse(renamed) as JsonValue);
  expect(buttonTitles(kButtons, answerTitles(own, ask))[1]).toBe("Leave it");
  expect(buttonTitles(["Retry", "Skip"], new Map([["Retry", "Go on"], ["Skip", "Go on"]]))).toEqual(["Retry", "Skip"]);
});
