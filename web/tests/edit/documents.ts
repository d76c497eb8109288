// Documents of tests, and their texts.
import { readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { Refusal } from "../../shared/edit/refusal";
import { documentOf, readTree, type Tree } from "../../shared/edit/tree";
import type { JsonValue } from "../../shared/json";
import { readJson } from "../files";

const folder = new URL("../../../api/examples/edits/", import.meta.url);

/** The test vectors whose names begin with `prefix`. */
export const vectorNames = (prefix: string): readonly string[] => readdirSync(fileURLToPath(folder)).filter((name) => name.startsWith(prefix));

export const vector = (name: string): unknown => readJson(new URL(name, folder));

export function treeOf(document: JsonValue): Tree {
  const tree = readTree(document);
  if (tree instanceof Refusal) throw tree;
  return tree;
}

function sorted(value: JsonValue): JsonValue {
  if (typeof value !== "object" || value === null) return value;
  if (Array.isArray(value)) return value.map(sorted);
  return Object.fromEntries(Object.entries(value).sort(([a], [b]) => (a < b ? -1 : 1)).map(([key, item]) => [key, sorted(item)]));
}

/** Equal values have the same text: JSON with sorted keys. */
export const textOf = (value: unknown): string => JSON.stringify(sorted(value as JsonValue));

export const documentText = (tree: Tree): string => textOf(documentOf(tree));
