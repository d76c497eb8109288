// Whether two values of JSON are equal; the order of the entries of an object says nothing.
import { isObject, type JsonValue } from "../../json";

const isList = (value: JsonValue | undefined): value is readonly JsonValue[] => Array.isArray(value);

/** Nothing is equal to nothing alone. */
export function isSame(one: JsonValue | undefined, other: JsonValue | undefined): boolean {
  if (one === other) return true;
  if (isList(one)) return isList(other) && one.length === other.length && one.every((item, i) => isSame(item, other[i]));
  if (!isObject(one) || !isObject(other)) return false;
  const keys = Object.keys(one);
  return keys.length === Object.keys(other).length && keys.every((key) => Object.hasOwn(other, key) && isSame(one[key], other[key]));
}
