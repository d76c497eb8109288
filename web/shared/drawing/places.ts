// Where a person has placed states and barriers: the field `layout` of a document (api/schemas/document.json).
import { entryOf, isObject, type JsonValue } from "../json";
import type { Identified } from "../model/model";
import type { Point, Side } from "./drawing";

/** Relative to the content area of the parent, in pixels at zoom 1. */
export interface Place extends Point {
  /** The border of the node on which its ports stand. */
  readonly side: Side;
  /** Id of the state in which it was placed there; in another one it is automatic. */
  readonly parent?: string;
}

/** Places of nodes by their ids. */
export type Places = ReadonlyMap<string, Place>;

export const kNoPlaces: Places = new Map();

/** Farther away nothing can be drawn [px]. */
const kFarthest = 1e6;

const coordinate = (value: JsonValue | undefined): number | undefined => (typeof value === "number" && Math.abs(value) <= kFarthest ? value : undefined);

function placeIn(entry: JsonValue): Place | undefined {
  if (!isObject(entry)) return undefined;
  const [x, y] = [coordinate(entryOf(entry, "x")), coordinate(entryOf(entry, "y"))];
  if (x === undefined || y === undefined) return undefined;
  const parent = entryOf(entry, "parent");
  return { x, y, side: entryOf(entry, "side") === "SOUTH" ? "SOUTH" : "EAST", ...(typeof parent === "string" && { parent }) };
}

const known = new WeakMap<object, Places>();

/** The places in `layout`; what is none is left out. The same object for the same `layout`. */
export function placesIn(layout: JsonValue | undefined): Places {
  if (!isObject(layout)) return kNoPlaces;
  const before = known.get(layout);
  if (before !== undefined) return before;
  const found = new Map(Object.entries(layout).flatMap(([id, entry]) => {
    const place = placeIn(entry);
    return place === undefined ? [] : [[id, place] as const];
  }));
  known.set(layout, found);
  return found;
}

/** The place of a child of `parent`, if a person has placed it there. */
export function placeOfChild(places: Places, parent: Identified, { id }: Identified): Place | undefined {
  const place = id === undefined ? undefined : places.get(id);
  return place?.parent === undefined || place.parent === parent.id ? place : undefined;
}
