// What a state declares: of a link, what its library state declares, with what the link itself says before it (core/SEMANTICS.md, section 8).
import type { ListName } from "../edit/element";
import { nameOfElement } from "../edit/commands/command";
import { elementOf, listOf, type Tree } from "../edit/tree";
import { entryOf, isObject, type JsonObject, type JsonValue } from "../json";

/** A parameter, result or port of a state. */
export interface Declared {
  readonly name: string;
  /** The element of the state itself that says something of it; nothing: all of it is the library's. */
  readonly own: string | undefined;
  readonly fields: JsonObject;
  readonly meta: JsonObject;
}

const kNone: JsonObject = {};
/** Links within the library that lead in a circle are an error of the draft. */
const kMostLinks = 64;

export const textOf = (value: JsonValue | undefined): string | undefined => (typeof value === "string" && value !== "" ? value : undefined);

export function metaOf(tree: Tree, id: string): JsonObject {
  const meta = entryOf(elementOf(tree, id).fields, "meta");
  return isObject(meta) ? meta : kNone;
}

/** The library state that a state links; nothing: it links none, or none that is there. */
export function linkedState(tree: Tree, id: string): string | undefined {
  const link = textOf(entryOf(elementOf(tree, id).fields, "link"));
  return link === undefined ? undefined : tree.library.find((each) => nameOfElement(tree, each) === link);
}

/** The constant of a link takes the place of a library's expression, and the other way round. */
function over(own: JsonObject, below: JsonObject): JsonObject {
  const { value: _value, from: _from, ...rest } = below;
  return Object.hasOwn(own, "value") || Object.hasOwn(own, "from") ? { ...rest, ...own } : { ...below, ...own };
}

export function declaredIn(tree: Tree, state: string, list: Exclude<ListName, "children" | "library" | "actions">, links = 0): readonly Declared[] {
  const linked = linkedState(tree, state);
  const below = linked === undefined || links === kMostLinks ? [] : declaredIn(tree, linked, list, links + 1);
  const own = listOf(tree, state, list).map((id): Declared => ({ name: nameOfElement(tree, id), own: id, fields: elementOf(tree, id).fields, meta: metaOf(tree, id) }));
  const merged = below.map((each): Declared => {
    const mine = own.find(({ name }) => name === each.name);
    return mine === undefined ? { ...each, own: undefined } : { ...mine, fields: over(mine.fields, each.fields), meta: { ...each.meta, ...mine.meta } };
  });
  return [...merged, ...own.filter(({ name }) => !below.some((each) => each.name === name))];
}

/** `meta` of a state, entry by entry over that of what it links. */
export function mergedMeta(tree: Tree, state: string, links = 0): JsonObject {
  const linked = linkedState(tree, state);
  return linked === undefined || links === kMostLinks ? metaOf(tree, state) : { ...mergedMeta(tree, linked, links + 1), ...metaOf(tree, state) };
}
