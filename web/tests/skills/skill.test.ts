// What a document says of its skills, which services they need, and how they come into another document.
import { expect, test } from "vitest";
import { apply, type Operation } from "../../shared/edit/apply";
import { plain, readExact, writeExact } from "../../shared/edit/exact";
import { Refusal } from "../../shared/edit/refusal";
import { documentOf, type Tree } from "../../shared/edit/tree";
import { nameOfElement } from "../../shared/edit/commands/command";
import type { JsonValue } from "../../shared/json";
import { missingServices, servicesOf, serviceText } from "../../shared/skills/closure";
import { copyState, type Copied } from "../../shared/skills/copy";
import { namedIn } from "../../shared/skills/named";
import { searchSkills, skillOf, skillsIn, supportOf } from "../../shared/skills/skill";
import { treeOf } from "../edit/documents";
import { emptyApp, emptyJson, skills, skillsJson, stateNamed } from "./fixture";

const { tree } = skills;
const state = (name: string) => stateNamed(tree, name);
const names = (of: Tree) => of.library.map((id) => nameOfElement(of, id));

function newIds(): () => string {
  let count = 0;
  return () => `new${++count}`;
}

function after(target: Tree, copied: Copied): Tree {
  if ("reason" in copied) throw new Error(copied.reason);
  const applied = apply(target, { operations: plain<readonly Operation[]>(copied.operations) });
  if (applied instanceof Refusal) throw applied;
  return applied.tree;
}

test("skills are the library states that are marked", () => {
  expect(skillsIn(tree).map(({ name }) => name)).toEqual(["MoveTo", "Wait", "Say", "AskYesNo", "FindPart", "PickPart"]);
  expect(["Retry", "WhatNow", "Repeat", "MoveTo"].map((name) => supportOf(tree, state(name)))).toEqual(["retry", "ask", "repeat", undefined]);
});

test("a skill has its name, picture, parameters, results and ports for people", () => {
  const skill = skillOf(tree, state("MoveTo"));
  expect(skill).toMatchObject({ title: "Move to", icon: "move", category: "motion", nominal: "success", doc: "Moves the arm to a place that it was shown." });
  expect(skill.parameters.map(({ name, title, domain, advanced }) => [name, title, domain, advanced])).toEqual([["pose", "Place", "pose", false], ["speed", "Speed", "speed", false], ["kind", "Way", undefined, true]]);
  expect(skill.parameters[1]).toMatchObject({ min: 0.05, max: 1, step: 0.05 });
  expect(skill.parameters[2]?.choices).toEqual([{ value: "ptp", title: "Fastest" }, { value: "lin", title: "Straight" }]);
  expect(skill.ports.map(({ name, advice }) => [name, advice])).toEqual([["success", undefined], ["unknown", "Show the place to the arm again."], ["error", "Look whether something is in its way."]]);
  expect(skillOf(tree, state("FindPart")).results).toEqual([{ name: "part", title: "Part", domain: "found" }]);
});

test("the nominal port is the marked one, else `success`, else the first that is no error", () => {
  const nominal = (ports: readonly JsonValue[]) => skillOf(treeOf({ rcm: 1, root: { state: "R", meta: { id: "r" }, ports } }), "r").nominal;
  const port = (name: string, meta = {}): JsonValue => ({ name, when: "True", meta: { id: name, ...meta } });
  expect(nominal([port("a"), port("success"), port("b", { nominal: true })])).toBe("b");
  expect(nominal([port("a"), port("success")])).toBe("success");
  expect(nominal([port("a", { advice: "Do." }), port("b")])).toBe("b");
  expect(nominal([port("a", { advice: "Do." })])).toBeUndefined();
});

test("a link says more than its library state, entry by entry", () => {
  const linked = treeOf({
    rcm: 1, library: [{ state: "S", doc: "Does.", meta: { id: "s", title: "Does", icon: "time" }, parameters: [{ name: "p", value: 1, unit: "m", meta: { id: "p", title: "P", min: 0 } }] }],
    root: { state: "R", meta: { id: "r" }, children: [{ state: "L", link: "S", meta: { id: "l", title: "Mine" }, parameters: [{ name: "p", from: "par.x", meta: { id: "lp", min: 2 } }] }] },
  });
  expect(skillOf(linked, "l")).toMatchObject({ title: "Mine", icon: "time", doc: "Does.", parameters: [{ title: "P", min: 2, unit: "m" }] });
});

test("a search finds skills by all its words", () => {
  const found = (query: string) => searchSkills(skillsIn(tree), query).map(({ name }) => name);
  expect(found("part")).toEqual(["FindPart", "PickPart"]);
  expect(found("PICK part")).toEqual(["PickPart"]);
  expect(found("gripper")).toEqual(["PickPart"]);
  expect(found(" ")).toHaveLength(6);
});

test("a skill needs the services of its code and of what it links", () => {
  expect(servicesOf(tree, state("MoveTo"))).toEqual(["db", "robot"]);
  expect(servicesOf(tree, state("Retry"))).toEqual([]);
  const timed = treeOf({ rcm: 1, root: { state: "R", meta: { id: "r" }, entry: "x = 'svc.robot'  # svc.audio", ports: [{ name: "p", after: "1.0", meta: { id: "p" } }] } });
  expect(servicesOf(timed, "r")).toEqual(["timer"]);
});

test("what is missing of the services is said by key or type", () => {
  const here = (key: string, type: string, available = true) => ({ key, type, available });
  expect(missingServices(tree, state("MoveTo"), [here("db", "database"), here("robot", "robot")])).toEqual([]);
  expect(missingServices(tree, state("MoveTo"), [here("store", "database"), here("robot", "robot", false)])).toEqual(["robot"]);
  expect(serviceText("robot")).toBe("the robot");
  expect(serviceText("laser")).toBe("the service laser");
});

test("a skill is copied with what it links and the services that it needs, numbers as they were written", () => {
  const copied = copyState(emptyApp, skills, state("MoveTo"), newIds());
  const next = after(emptyApp, copied);
  expect(names(next)).toEqual(["GetPose", "MoveTo"]);
  expect(documentOf(next).services).toEqual({ db: "database", robot: "robot" });
  const exact = '{"rcm":1,"library":[{"state":"W","parameters":[{"name":"s","value":1.0,"meta":{"id":"s"}}],"meta":{"id":"w","skill":true}}],"root":{"state":"R","meta":{"id":"r"}}}';
  const written = copyState(emptyApp, exactDocument(exact), "w", newIds());
  expect("operations" in written && writeExact(written.operations)).toContain('"value":1.0');
});

function exactDocument(text: string) {
  const json = JSON.parse(text) as JsonValue;
  return { name: "exact", tree: treeOf(json), exact: readExact(text) };
}

test("ids are new, and a state that is there already is used", () => {
  const once = after(emptyApp, copyState(emptyApp, skills, state("MoveTo"), newIds()));
  for (const id of once.elements.keys()) expect(id === "root" || id.startsWith("new")).toBe(true);
  const twice = copyState(once, skills, state("MoveTo"), newIds());
  expect(twice).toEqual({ operations: [], link: "MoveTo" });
});

test("another state of the name gets company under a new name, which its links know", () => {
  const json = { ...(emptyJson as object), library: [{ state: "GetPose", entry: "pass", meta: { id: "other" } }] } as unknown as JsonValue;
  const target = treeOf(json);
  const next = after(target, copyState(target, skills, state("MoveTo"), newIds()));
  expect(names(next)).toEqual(["GetPose", "GetPose2", "MoveTo"]);
  expect(JSON.stringify(documentOf(next))).toContain('"link":"GetPose2"');
  expect(copyState(next, skills, state("MoveTo"), () => "more")).toEqual({ operations: [], link: "MoveTo" });
});

test("the poses and labels that a document names are told", () => {
  const json = { ...(skillsJson as object), root: { state: "R", meta: { id: "r" }, children: [{ state: "A", link: "MoveTo", meta: { id: "a" }, parameters: [{ name: "pose", value: "home", meta: { id: "ap" } }] }, { state: "B", meta: { id: "b" }, parameters: [{ name: "labels", value: ["Tape"], meta: { id: "bl" } }, { name: "pose", value: "none", meta: { id: "bp" } }] }] } } as unknown as JsonValue;
  expect(namedIn(treeOf(json))).toEqual({ poses: ["home"], labels: ["Tape", "Cube", "Box"] });
});

test("a service of the same key and another type is in the way", () => {
  const target = treeOf({ ...(emptyJson as object), services: { robot: "crane" } } as unknown as JsonValue);
  expect(copyState(target, skills, state("MoveTo"), newIds())).toEqual({ reason: "the robot is another one here: `crane`, not `robot`" });
});
