// Numbers as RACE-One writes them: what is no count has a decimal point, so that it stays a float.
import { NumberText } from "../edit/exact";

/** `whole`: of an int. Otherwise 10 is written `10.0`. */
export function exactNumber(value: number, whole: boolean): number | NumberText {
  return whole || !Number.isInteger(value) || Math.abs(value) >= 1e15 ? value : new NumberText(`${Object.is(value, -0) ? 0 : value}.0`);
}
