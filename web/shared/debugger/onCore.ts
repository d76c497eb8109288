// The breakpoints of a core, which may be those of several people: each sets their own.
import type { Breakpoint, Core, ServerError } from "../../generated/messages";

/** The same text for breakpoints that mean the same. */
export const breakpointKey = ({ when, id, path, before = false, service = "", operation = "", condition = "" }: Breakpoint): string =>
  JSON.stringify([when, id, path, before, service, operation, condition]);

/** Those that a person has set in a core. */
export const setBy = ({ breakpoints }: Pick<Core, "breakpoints">, author: string): readonly Breakpoint[] => breakpoints.filter((each) => each.author === author);

/** Those of a person that a core has not got. */
export function missingOn(core: Pick<Core, "breakpoints">, author: string, mine: readonly Breakpoint[]): readonly Breakpoint[] {
  const has = new Set(setBy(core, author).map(breakpointKey));
  return mine.filter((each) => !has.has(breakpointKey(each)));
}

export const sameBreakpoints = (one: readonly Breakpoint[], other: readonly Breakpoint[]): boolean =>
  one.length === other.length && one.every((each, i) => other[i] !== undefined && breakpointKey(each) === breakpointKey(other[i]));

/** Which breakpoint of a request the server does not take, and why; nothing: its answer is about something else. */
export function refusedOne(errors: readonly ServerError[]): { readonly index: number; readonly message: string } | undefined {
  for (const { path, message } of errors) {
    const [, index, field] = /^breakpoints\/(\d+)\/?(.*)$/.exec(path) ?? [];
    if (index !== undefined) return { index: Number(index), message: field === "condition" ? `condition: ${message}` : message };
  }
  return undefined;
}
