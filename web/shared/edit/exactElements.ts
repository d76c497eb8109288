// The elements of a document with their numbers as the server has written them.
import { NumberText, type ExactJson } from "./exact";

export type ExactObject = Readonly<Record<string, ExactJson>>;

const isExactObject = (value: ExactJson | undefined): value is ExactObject =>
  typeof value === "object" && value !== null && !Array.isArray(value) && !(value instanceof NumberText);

function idOf(element: ExactObject): string | undefined {
  const meta = element["meta"];
  const id = isExactObject(meta) ? meta["id"] : undefined;
  return typeof id === "string" ? id : undefined;
}

/** The lists in which elements stand. */
const kLists = ["parameters", "results", "variables", "actions", "children", "ports"] as const;

/** All elements of a document by their ids. `document`: what readExact made of its text. */
export function exactElements(document: ExactJson): ReadonlyMap<string, ExactObject> {
  const found = new Map<string, ExactObject>();
  const listIn = (object: ExactObject, list: string): readonly ExactJson[] => {
    const items = object[list];
    return Array.isArray(items) ? (items as readonly ExactJson[]) : [];
  };
  const open: ExactJson[] = isExactObject(document) ? [document["root"] ?? null, ...listIn(document, "library")] : [];
  for (let element = open.pop(); element !== undefined; element = open.pop()) {
    if (!isExactObject(element)) continue;
    const id = idOf(element);
    if (id !== undefined) found.set(id, element);
    for (const list of kLists) for (const inner of listIn(element, list)) open.push(inner);
  }
  return found;
}
