// The skills of these tests, and an empty application.
import { readExact, type ExactJson } from "../../shared/edit/exact";
import { documentOf, type Tree } from "../../shared/edit/tree";
import type { JsonValue } from "../../shared/json";
import type { SkillDocument } from "../../shared/skills/copy";
import { treeOf } from "../edit/documents";
import { readJson } from "../files";

export const skillsJson = readJson(new URL("skills.rcm.json", import.meta.url)) as JsonValue;

/** A document as the server has written it. */
export const exactOf = (tree: Tree): ExactJson => readExact(JSON.stringify(documentOf(tree)));

export function skillDocument(name: string, json: JsonValue): SkillDocument {
  return { name, tree: treeOf(json), exact: readExact(JSON.stringify(json)) };
}

export const skills = skillDocument("skills", skillsJson);

/** The library state of a name. */
export function stateNamed(tree: Tree, name: string): string {
  const found = tree.library.find((id) => tree.elements.get(id)?.fields["state"] === name);
  if (found === undefined) throw new Error(`there is no ${name}`);
  return found;
}

export const emptyJson: JsonValue = { rcm: 1, name: "app", root: { state: "App", meta: { id: "root" } } };
export const emptyApp = treeOf(emptyJson);
