// How parameters are entered.
import { expect, test } from "vitest";
import { writeExact } from "../../shared/edit/exact";
import type { JsonValue } from "../../shared/json";
import { fieldOf, limitsText, numberText, readNumber, reasonAgainstPose, shownNumber, valueText, wordFor, type NumberField } from "../../shared/skills/form";
import { iconPath, kIconNames } from "../../shared/skills/icons";
import { kCategories, type SkillParameter } from "../../shared/skills/skill";

const parameter = (about: Partial<SkillParameter>): SkillParameter => ({
  name: "p", title: "P", doc: undefined, type: undefined, unit: undefined, domain: undefined, min: undefined, max: undefined, step: undefined, choices: [], advanced: false, internal: false, teaches: false, ...about,
});
function numberOf(about: Partial<SkillParameter>): NumberField {
  const field = fieldOf(parameter(about));
  if (field.kind !== "slider" && field.kind !== "number") throw new Error(`it is a ${field.kind}`);
  return field;
}

test.each<[Partial<SkillParameter>, string]>([
  [{ domain: "pose", type: "string" }, "pose"],
  [{ domain: "label", type: "string" }, "label"],
  [{ domain: "labels", type: { list: "string" } }, "labels"],
  [{ domain: "found", type: "any" }, "found"],
  [{ domain: "speed", type: "number" }, "slider"],
  [{ domain: "force", type: "number" }, "slider"],
  [{ domain: "distance", type: "number", unit: "m", min: 0, max: 0.5 }, "slider"],
  [{ domain: "duration", type: "number" }, "number"],
  [{ domain: "duration", type: "number", max: 60 }, "slider"],
  [{ domain: "count", type: "int" }, "number"],
  [{ domain: "count", type: "int", max: 100 }, "number"],
  [{ domain: "count", type: "int", min: 1, max: 10 }, "slider"],
  [{ domain: "text", type: "string" }, "text"],
  [{ domain: "sound", type: "string" }, "text"],
  [{ domain: "sound", type: "string", choices: [{ value: "beep", title: "Beep" }] }, "choice"],
  [{ domain: "colour", type: "string" }, "colour"],
  [{ domain: "direction", type: "string", choices: [{ value: "up", title: "Up" }] }, "choice"],
  [{ domain: "somethingNew", type: "bool" }, "toggle"],
  [{ type: "bool" }, "toggle"],
  [{ type: "int" }, "number"],
  [{ type: "number", min: 0, max: 1 }, "slider"],
  [{ type: "string" }, "text"],
  [{ type: { list: "string" } }, "texts"],
  [{ type: { enum: ["a", "b"] } }, "choice"],
  [{ type: "pose" }, "other"],
  [{ type: { record: { x: "number" } } }, "other"],
  [{ type: { optional: "number" }, min: 0, max: 1 }, "slider"],
  [{ type: { optional: { enum: ["a", "b"] } } }, "choice"],
  [{ type: { optional: "bool" } }, "other"],
  [{ type: { optional: "pose" } }, "other"],
  [{}, "other"],
])("%j is entered as %s", (about, kind) => {
  expect(fieldOf(parameter(about)).kind).toBe(kind);
});

test("a parameter that says nothing of itself is entered as its value is", () => {
  expect([true, "a", 1.5, [1]].map((value: JsonValue) => fieldOf(parameter({}), value).kind)).toEqual(["toggle", "text", "number", "other"]);
});

test("forces and speeds have everyday words, with the number", () => {
  const force = numberOf({ domain: "force" });
  expect([10, 25, 40].map((value) => numberText(force, value))).toEqual(["gentle 10 N", "medium 25 N", "firm 40 N"]);
  expect([0.1, 0.5, 1].map((value) => numberText(numberOf({ domain: "speed" }), value))).toEqual(["slow 10 %", "medium 50 %", "fast 100 %"]);
  expect([wordFor("force", 15), wordFor("force", 35), wordFor("speed", 0.3), wordFor("speed", 0.65)]).toEqual(["medium", "firm", "medium", "fast"]);
});

test("numbers are shown in units of every day, and limits with them", () => {
  const distance = numberOf({ domain: "distance", max: 0.5 });
  expect(numberText(distance, 0.055)).toBe("5.5 cm");
  expect(limitsText(distance)).toBe("0 cm to 50 cm");
  expect(numberText(numberOf({ domain: "distance", max: 3 }), 2)).toBe("2 m");
  expect(numberText(numberOf({ type: "number", unit: "rad" }), Math.PI)).toBe("180°");
  expect(shownNumber(distance, 0.07)).toBe("7");
  expect(limitsText(numberOf({ domain: "count", type: "int" }))).toBe("at least 0");
});

test.each<[Partial<SkillParameter>, string, string]>([
  [{ type: "number" }, "1.50", "1.50"],
  [{ type: "number" }, "10", "10.0"],
  [{ type: "number" }, " 0,5 ", "0.5"],
  [{ type: "number" }, ".5", "0.5"],
  [{ type: "number" }, "007.5", "7.5"],
  [{ type: "int" }, "10", "10"],
  [{ domain: "count" }, "3", "3"],
  [{ domain: "speed" }, "35", "0.35"],
  [{ domain: "speed" }, "100", "1.0"],
  [{ domain: "distance", max: 0.5 }, "7", "0.07"],
  [{ domain: "distance", max: 0.5 }, "5.5", "0.055"],
])("%j: what is typed as %j is written %s", (about, typed, written) => {
  const read = readNumber(numberOf(about), typed);
  expect("value" in read ? writeExact(read.value) : read.problem).toBe(written);
});

test.each<[Partial<SkillParameter>, string, string]>([
  [{ type: "number" }, "", "a number, please"],
  [{ type: "number" }, "1e3", "a number, please"],
  [{ type: "int" }, "1.5", "a whole number, please"],
  [{ domain: "force" }, "81", "5 N to 80 N"],
  [{ domain: "force" }, "4", "5 N to 80 N"],
])("%j: %j is refused", (about, typed, problem) => {
  expect(readNumber(numberOf(about), typed)).toEqual({ problem });
});

test("values are told in words", () => {
  const text = (about: Partial<SkillParameter>, value: JsonValue) => valueText(parameter(about), value);
  expect(text({ domain: "force" }, 10)).toBe("gentle 10 N");
  expect(text({ choices: [{ value: "lin", title: "Straight" }] }, "lin")).toBe("Straight");
  expect(text({ type: "bool" }, false)).toBe("no");
  expect(text({ domain: "labels" }, ["Cube", "Box"])).toBe("Cube, Box");
  expect(text({ domain: "labels" }, [])).toBe("all");
  expect(text({ type: "string" }, "Hello")).toBe("Hello");
  expect(text({ type: "any" }, { x: 1 })).toBe('{"x":1}');
});

test("a taught pose has a name that a key can have", () => {
  expect(reasonAgainstPose("above_table-2")).toBeUndefined();
  for (const name of ["", "ü", "a b", "a".repeat(33)]) expect(reasonAgainstPose(name)).toBeDefined();
});

test("every category has a picture, and so has a skill without one", () => {
  for (const category of kCategories) expect(kIconNames.map((name) => iconPath(name, undefined))).toContain(iconPath("constructor", category));
  expect(iconPath(undefined, undefined)).not.toBe("");
});
