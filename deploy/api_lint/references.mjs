// References ($ref) of documents to parts of themselves and to files beside them.
import { readFileSync } from "node:fs";
import { join } from "node:path";

/** Every `$ref` in `value`: {path, target}, the path being the keys to it. */
function referencesIn(value, path = []) {
  if (typeof value !== "object" || value === null) return [];
  return Object.entries(value).flatMap(([key, inner]) =>
    key === "$ref" && typeof inner === "string" ? [{ path: [...path, key], target: inner }] : referencesIn(inner, [...path, key]),
  );
}

/** The value at a JSON pointer ("" or "/a/b"); undefined if there is none. */
function lookUp(document, pointer) {
  const keys = pointer.split("/").slice(1).map((key) => decodeURIComponent(key).replaceAll("~1", "/").replaceAll("~0", "~"));
  const isThere = (value, key) => typeof value === "object" && value !== null && Object.hasOwn(value, key);
  return keys.reduce((value, key) => (isThere(value, key) ? value[key] : undefined), document);
}

/** The content of a JSON file; undefined if there is none. */
function readJson(file) {
  try {
    return JSON.parse(readFileSync(file, "utf8"));
  } catch {
    return undefined;
  }
}

/** The `$ref`s of `document`, a file in `folder`, that lead nowhere. A file that is named is JSON. */
export function unresolvedIn(document, folder) {
  return referencesIn(document).filter(({ target }) => {
    const [name, pointer = ""] = target.split("#");
    return lookUp(name === "" ? document : readJson(join(folder, name)), pointer) === undefined;
  });
}
