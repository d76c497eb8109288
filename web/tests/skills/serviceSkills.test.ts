// What services offer, as skills.
import { expect, test } from "vitest";
import type { RsmOperation } from "../../generated/messages";
import { apply, type Operation } from "../../shared/edit/apply";
import { plain } from "../../shared/edit/exact";
import { documentOf, type Tree } from "../../shared/edit/tree";
import type { JsonValue } from "../../shared/json";
import { copyState } from "../../shared/skills/copy";
import { fieldOf, valueText } from "../../shared/skills/form";
import { keepServices, madeDocuments, madeOf, searchOperations, servicesWithoutSkills, skillsOfService } from "../../shared/skills/serviceSkills";
import { nominalOf, skillsIn } from "../../shared/skills/skill";
import { treeOf } from "../edit/documents";
import { emptyApp, skills as written } from "./fixture";
import { gripper, serviceOf } from "./services";

function madeBy(service: typeof gripper) {
  const found = skillsOfService(service);
  if (found === undefined) throw new Error("nothing is made of it");
  return found;
}
const named = (service: typeof gripper, name: string) => {
  const skill = madeBy(service).skills.get(name);
  if (skill === undefined) throw new Error(`there is no ${name}`);
  return skill;
};

let count = 0;
const newId = (): string => `new${++count}`;
function copiedInto(target: Tree, service: typeof gripper, name: string): Tree {
  const copied = copyState(target, madeBy(service).document, named(service, name).id, newId);
  if ("reason" in copied) throw new Error(copied.reason);
  const applied = apply(target, { operations: plain<readonly Operation[]>(copied.operations) });
  if (!("tree" in applied)) throw applied;
  return applied.tree;
}
const offering = (service: typeof gripper, available = true) => ({ ...service, available });

test("each operation that is offered is a skill, with fields for its parameters, an outcome and an error", () => {
  expect([...madeBy(gripper).skills.keys()]).toEqual(["move", "get"]);
  const move = named(gripper, "move");
  expect(move).toMatchObject({ name: "MyGripperMove", title: "Move (my_gripper)", doc: "Calls move of the service my_gripper.", category: undefined, nominal: "done" });
  expect(nominalOf(move.ports)).toBe("done");
  expect(move.ports.map(({ name, advice }) => [name, advice !== undefined])).toEqual([["done", false], ["error", true]]);
  const [width] = move.parameters;
  if (width === undefined) throw new Error("it has no parameter");
  expect(fieldOf(width)).toMatchObject({ kind: "slider", min: 0, max: 0.11, step: 0.002, unit: "cm" });
  expect(valueText(width, 0.05)).toBe("5 cm");
  expect(named(gripper, "get").parameters).toEqual([]);
});

test("one that is added brings its service, and is used again; the mark says that nobody has written it", () => {
  const once = copiedInto(emptyApp, gripper, "get");
  expect(documentOf(once).services).toEqual({ my_gripper: "my_gripper" });
  expect(skillsIn(once).map(({ id }) => madeOf(once, id))).toEqual(["my_gripper"]);
  expect(copyState(once, madeBy(gripper).document, named(gripper, "get").id, newId)).toEqual({ operations: [], link: "MyGripperGet" });
  expect(skillsIn(written.tree).map(({ id }) => madeOf(written.tree, id))).toEqual(skillsIn(written.tree).map(() => undefined));
});

test("another RSM gives another skill beside the one that a document has", () => {
  const once = copiedInto(emptyApp, gripper, "move");
  const anew = serviceOf("my_gripper", [{ name: "move", parameters: [{ name: "width" }, { name: "force", value: 3 }] }]);
  expect(skillsIn(copiedInto(once, anew, "move")).map(({ name }) => name)).toEqual(["MyGripperMove", "MyGripperMove2"]);
});

test("a document in which the key stands for another type refuses it", () => {
  const other = treeOf({ rcm: 1, services: { my_gripper: "wsg50" }, root: { state: "R", meta: { id: "root" } } });
  expect(copyState(other, madeBy(gripper).document, named(gripper, "get").id, newId)).toEqual({ reason: "the service my_gripper is another one here: `wsg50`, not `my_gripper`" });
});

test("operations whose names make the same name of a state are two skills", () => {
  const service = serviceOf("s", [{ name: "move_to" }, { name: "moveTo" }, { name: "_move_to" }]);
  expect([...madeBy(service).skills.values()].map(({ name }) => name)).toEqual(["SMoveTo", "SMoveTo2", "SMoveTo3"]);
});

test("an RSM as long as it may be makes as many skills, whose titles and ids are short", () => {
  const operations: RsmOperation[] = [{ name: "n".repeat(2000) }, { name: `${"n".repeat(1999)}m` }];
  while (JSON.stringify(operations).length < 64 * 1024) operations.push({ name: `o${operations.length}` });
  const { document, skills } = madeBy(serviceOf("s", operations));
  expect(skills.size).toBe(operations.length);
  expect(new Set(document.tree.library).size).toBe(operations.length);
  expect(Math.max(...[...skills.values()].map(({ title }) => title.length))).toBe(40);
});

test("skills are made once for each RSM, and only those that were made are there to be added", () => {
  const [one, two] = [serviceOf("one", [{ name: "a" }]), serviceOf("two", [{ name: "a" }])];
  expect(madeDocuments([one, two])).toEqual([]);
  expect(skillsOfService(one)).toBe(skillsOfService({ ...one }));
  expect(madeDocuments([one, two]).map(({ name }) => name)).toEqual(["svc.one"]);
  expect(madeDocuments([{ ...one, rsm: { ...one.rsm } }])).toEqual([]);
});

test("a search finds operations by all its words, in name, description and service", () => {
  const found = (query: string) => searchOperations(serviceOf("lamp", [{ name: "turn_on", doc: "Makes light" }, { name: "blink" }, { name: "halt", safe: true }]), query).map(({ name }) => name);
  expect([found(""), found("LIGHT turn"), found("turn on"), found("turn_on lamp"), found("halt"), found("nothing")]).toEqual([["turn_on", "blink"], ["turn_on"], ["turn_on"], ["turn_on"], [], []]);
});

test("services that a written skill uses are left out: by key, else by type", () => {
  const keys = (services: readonly (readonly [key: string, type: string])[], trees: readonly Tree[]) => servicesWithoutSkills(services.map(([key, type]) => ({ key, type, available: false })), trees).map(({ key }) => key);
  // The skills for tests use robot, db, display and others.
  expect(keys([["robot", "robot"], ["my_gripper", "my_gripper"]], [written.tree])).toEqual(["my_gripper"]);
  expect(keys([["arm", "robot"], ["my_gripper", "my_gripper"]], [written.tree])).toEqual(["my_gripper"]);
  expect(keys([["robot", "robot"], ["arm", "robot"]], [written.tree])).toEqual(["arm"]);
  expect(keys([["my_gripper", "my_gripper"]], [])).toEqual(["my_gripper"]);
});

test("a skill that was made of a service does not count as written; one without the mark does", () => {
  const tree = copiedInto(emptyApp, gripper, "get");
  const here = [offering(gripper)];
  expect(servicesWithoutSkills(here, [tree])).toEqual(here);
  const text = JSON.stringify(documentOf(tree)).replace('"operation":"my_gripper.get",', "");
  const own = treeOf(JSON.parse(text) as JsonValue);
  expect(text.includes('"operation":')).toBe(false);
  expect(servicesWithoutSkills(here, [own])).toEqual([]);
});

test("the list of services stays the same while they work", () => {
  const keep = keepServices();
  const first = keep([offering(gripper)]);
  expect(keep([offering(gripper)])).toBe(first);
  expect(keep([offering(gripper, false)])).not.toBe(first);
  const gone = keep([offering(gripper, false)]);
  expect(keep([offering({ ...gripper, rsm: { ...gripper.rsm } }, false)])).not.toBe(gone);
  expect(keep([])).toEqual([]);
});
