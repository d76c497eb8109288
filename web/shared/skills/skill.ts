// Skills: library states as RACE-One shows them (api/skills.md).
import { nameOfElement } from "../edit/commands/command";
import { elementOf, type Tree } from "../edit/tree";
import { entryOf, isObject, type JsonObject, type JsonValue } from "../json";
import { declaredIn, linkedState, mergedMeta, metaOf, textOf, type Declared } from "./declared";

export const kCategories = ["motion", "gripper", "vision", "people", "flow"] as const;
export type Category = (typeof kCategories)[number];

export interface SkillChoice {
  readonly value: JsonValue;
  readonly title: string;
}

export interface SkillParameter {
  readonly name: string;
  readonly title: string;
  readonly doc: string | undefined;
  readonly type: JsonValue | undefined;
  readonly unit: string | undefined;
  readonly domain: string | undefined;
  readonly min: number | undefined;
  readonly max: number | undefined;
  readonly step: number | undefined;
  readonly choices: readonly SkillChoice[];
  readonly advanced: boolean;
  readonly internal: boolean;
  /** The skill teaches the pose of this name. */
  readonly teaches: boolean;
}

export interface SkillResult {
  readonly name: string;
  readonly title: string;
  readonly domain: string | undefined;
}

export interface SkillPort {
  readonly name: string;
  readonly title: string;
  /** Of an error. */
  readonly advice: string | undefined;
  readonly nominal: boolean;
}

/** States that RACE-One writes beside skills: Retry, WhatNow, Repeat. */
export type Support = "retry" | "ask" | "repeat";

export interface Skill {
  /** The state of which this is said. */
  readonly id: string;
  readonly name: string;
  readonly title: string;
  readonly icon: string | undefined;
  readonly category: Category | undefined;
  readonly doc: string | undefined;
  readonly parameters: readonly SkillParameter[];
  readonly results: readonly SkillResult[];
  readonly ports: readonly SkillPort[];
  /** Name of the port with which a task goes on; nothing: there are only errors. */
  readonly nominal: string | undefined;
}

const numberOf = (value: JsonValue | undefined): number | undefined => (typeof value === "number" ? value : undefined);
const isMarked = (meta: JsonObject, mark: string): boolean => entryOf(meta, mark) === true;

/** `stop_on_contact`, `StopOnContact`: `Stop on contact`. */
export function wordsOf(name: string): string {
  const words = name.replace(/([a-z0-9])([A-Z])/g, (_, before: string, after: string) => `${before} ${after.toLowerCase()}`).replace(/_/g, " ").trim();
  return words.charAt(0).toUpperCase() + words.slice(1);
}

const titleOf = (meta: JsonObject, name: string): string => textOf(entryOf(meta, "title")) ?? wordsOf(name);

function choicesOf(value: JsonValue | undefined): readonly SkillChoice[] {
  if (!Array.isArray(value)) return [];
  return value.flatMap((choice: JsonValue): readonly SkillChoice[] => {
    const constant = isObject(choice) ? entryOf(choice, "value") : choice;
    if (constant === undefined) return [];
    return [{ value: constant, title: (isObject(choice) ? textOf(entryOf(choice, "title")) : undefined) ?? (typeof constant === "string" ? constant : JSON.stringify(constant)) }];
  });
}

export function parameterOf({ name, fields, meta }: Declared): SkillParameter {
  return {
    name, title: titleOf(meta, name), doc: plainText(textOf(entryOf(fields, "doc"))), type: entryOf(fields, "type"), unit: textOf(entryOf(fields, "unit")), domain: textOf(entryOf(meta, "domain")),
    min: numberOf(entryOf(meta, "min")), max: numberOf(entryOf(meta, "max")), step: numberOf(entryOf(meta, "step")), choices: choicesOf(entryOf(meta, "choices")),
    advanced: isMarked(meta, "advanced"), internal: isMarked(meta, "internal"), teaches: isMarked(meta, "teaches"),
  };
}

/** `error` of a task is an error without advice, too (api/skills.md). */
const portOf = ({ name, meta }: Declared, isTask: boolean): SkillPort => ({
  name, title: textOf(entryOf(meta, "title")) ?? wordsOf(name), advice: textOf(entryOf(meta, "advice")) ?? (isTask && name === "error" ? "" : undefined), nominal: isMarked(meta, "nominal"),
});

/** The port with which a task goes on. */
export function nominalOf(ports: readonly SkillPort[]): string | undefined {
  const outcomes = ports.filter(({ advice }) => advice === undefined);
  return (outcomes.find(({ nominal }) => nominal) ?? outcomes.find(({ name }) => name === "success") ?? outcomes[0])?.name;
}

/** What any state is to RACE-One: a skill, a link to one, or a state that no one has marked. Requires the id of a state. */
export function skillOf(tree: Tree, id: string): Skill {
  const name = nameOfElement(tree, id);
  const meta = mergedMeta(tree, id);
  const isTask = entryOf(elementOf(tree, id).fields, "link") === undefined && metaOf(tree, id)["skill"] !== true;
  const ports = declaredIn(tree, id, "ports").map((port) => portOf(port, isTask));
  const category = textOf(entryOf(meta, "category"));
  return {
    id, name, title: titleOf(meta, name), icon: textOf(entryOf(meta, "icon")), category: kCategories.find((each) => each === category), doc: docOf(tree, id),
    parameters: declaredIn(tree, id, "parameters").map(parameterOf),
    results: declaredIn(tree, id, "results").map(({ name: result, meta: about }) => ({ name: result, title: titleOf(about, result), domain: textOf(entryOf(about, "domain")) })),
    ports, nominal: nominalOf(ports),
  };
}

/** Without the marks of code, which mean nothing to people. */
const plainText = (text: string | undefined): string | undefined => text?.replaceAll("`", "");

function docOf(tree: Tree, id: string): string | undefined {
  const { fields } = elementOf(tree, id);
  const linked = linkedState(tree, id);
  return plainText(textOf(entryOf(fields, "doc")) ?? (linked === undefined ? undefined : textOf(entryOf(elementOf(tree, linked).fields, "doc"))));
}

export const isSkill = (tree: Tree, id: string): boolean => isMarked(metaOf(tree, id), "skill");

const kSupports: Readonly<Record<Support, readonly string[]>> = { retry: ["again", "give_up"], ask: ["retry", "skip", "abort"], repeat: ["again", "done"] };

/** Which state beside skills a library state is: by its ports, as it may have another name where its own was taken. */
export function supportOf(tree: Tree, id: string): Support | undefined {
  if (!isMarked(metaOf(tree, id), "support")) return undefined;
  const ports = declaredIn(tree, id, "ports").map(({ name }) => name);
  return (Object.keys(kSupports) as Support[]).find((support) => kSupports[support].length === ports.length && kSupports[support].every((port) => ports.includes(port)));
}

/** The skills of a document, in the order of its library. */
export const skillsIn = (tree: Tree): readonly Skill[] => tree.library.filter((id) => isSkill(tree, id)).map((id) => skillOf(tree, id));

/** The skills with all words of the query in their title, description or category. */
export function searchSkills<T extends Skill>(skills: readonly T[], query: string): readonly T[] {
  const words = query.toLowerCase().split(/\s+/).filter((word) => word !== "");
  return skills.filter(({ title, doc = "", category = "" }) => words.every((word) => `${title} ${doc} ${category}`.toLowerCase().includes(word)));
}
