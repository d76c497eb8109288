// The breakpoints of a core, which may be those of several people: each adds and removes their own.
import type { Breakpoint, ServerError } from "../../generated/messages";

/** The same text for breakpoints that mean the same. */
export const breakpointKey = ({ when, id, path, before = false, service = "", operation = "", condition = "" }: Breakpoint): string =>
  JSON.stringify([when, id, path, before, service, operation, condition]);

/** Takes one of each of `taken` away. */
function without(all: readonly Breakpoint[], taken: readonly Breakpoint[]): readonly Breakpoint[] {
  const left = new Map<string, number>();
  for (const each of taken) left.set(breakpointKey(each), (left.get(breakpointKey(each)) ?? 0) + 1);
  return all.filter((each) => {
    const count = left.get(breakpointKey(each)) ?? 0;
    left.set(breakpointKey(each), count - 1);
    return count <= 0;
  });
}

/** What a core has after a person has changed theirs from `before` to `after`. */
export const withChanged = (onCore: readonly Breakpoint[], before: readonly Breakpoint[], after: readonly Breakpoint[]): readonly Breakpoint[] => [
  ...without(onCore, without(before, after)),
  ...without(after, before),
];

/** Those of a person that a core does not have. */
export const missingOn = (onCore: readonly Breakpoint[], mine: readonly Breakpoint[]): readonly Breakpoint[] => without(mine, onCore);

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
