// The breakpoints that a person keeps at a document, as a value, and what changes them.
import { assertNever } from "../assertNever";
import type { Breakpoint, KeptBreakpoint, When } from "../../generated/messages";
import { breakpointKey } from "./onCore";

/** As the server bounds it. */
export const kMostBreakpoints = 100;

/** What a breakpoint is at: an element by its id, or by its path or address if it has none. */
export interface Where {
  readonly id?: string;
  readonly path?: string;
}

export interface Entry {
  /** As long as the page has it, and no other one's. */
  readonly number: number;
  readonly breakpoint: KeptBreakpoint;
}

export type Fields = Partial<Pick<KeptBreakpoint, "enabled" | "before" | "condition" | "service" | "operation">>;

export type BreakpointChange =
  /** As the server keeps them. */
  | { readonly type: "loaded"; readonly breakpoints: readonly KeptBreakpoint[] }
  | { readonly type: "added"; readonly breakpoint: KeptBreakpoint }
  /** Adds one at this place, or removes those that are there. */
  | { readonly type: "toggled"; readonly when: When; readonly where: Where }
  /** An empty text, and `before: false`, take the field away. */
  | { readonly type: "set"; readonly number: number; readonly fields: Fields }
  | { readonly type: "removed"; readonly number: number };

/** Whether a breakpoint is at this place and of this kind. */
export const isAt = ({ breakpoint }: Entry, when: When, where: Where): boolean =>
  breakpoint.when === when && breakpoint.id === where.id && breakpoint.path === where.path;

/** A new one of this kind at this place. A condition that becomes fulfilled has to be one. */
export const newBreakpoint = (when: When, where?: Where): KeptBreakpoint => ({
  when, ...where, ...(when === "fault" && { before: true }), ...(when === "fulfilled" && { condition: "True" }), enabled: true,
});

function withFields(breakpoint: KeptBreakpoint, fields: Fields): KeptBreakpoint {
  const all = { ...breakpoint, ...fields };
  return Object.fromEntries(Object.entries(all).filter(([key, value]) => value !== "" && (key !== "before" || value === true))) as typeof all;
}

const nextNumber = (entries: readonly Entry[]): number => 1 + Math.max(0, ...entries.map(({ number }) => number));

function add(entries: readonly Entry[], breakpoint: KeptBreakpoint): readonly Entry[] {
  return entries.length >= kMostBreakpoints ? entries : [...entries, { number: nextNumber(entries), breakpoint }];
}

const isSame = (one: KeptBreakpoint, other: KeptBreakpoint | undefined): boolean => other !== undefined && one.enabled === other.enabled && breakpointKey(one) === breakpointKey(other);

/** If they are the same as before, they keep their numbers. */
function load(entries: readonly Entry[], breakpoints: readonly KeptBreakpoint[]): readonly Entry[] {
  if (entries.length === breakpoints.length && entries.every(({ breakpoint }, i) => isSame(breakpoint, breakpoints[i]))) return entries;
  const first = nextNumber(entries);
  return breakpoints.map((breakpoint, i) => ({ number: first + i, breakpoint }));
}

export function applyBreakpoints(entries: readonly Entry[], change: BreakpointChange): readonly Entry[] {
  switch (change.type) {
    case "loaded":
      return load(entries, change.breakpoints);
    case "added":
      return add(entries, change.breakpoint);
    case "toggled": {
      const others = entries.filter((entry) => !isAt(entry, change.when, change.where));
      return others.length < entries.length ? others : add(entries, newBreakpoint(change.when, change.where));
    }
    case "set":
      return entries.map((entry) => (entry.number === change.number ? { ...entry, breakpoint: withFields(entry.breakpoint, change.fields) } : entry));
    case "removed":
      return entries.filter(({ number }) => number !== change.number);
    default:
      return assertNever(change);
  }
}

/** As a core gets it. */
export function asSent(kept: KeptBreakpoint): Breakpoint {
  const { enabled, ...sent } = kept;
  return sent;
}

/** As cores get them: those that are enabled. */
export const enabledOf = (entries: readonly Entry[]): readonly Breakpoint[] => entries.filter(({ breakpoint }) => breakpoint.enabled).map(({ breakpoint }) => asSent(breakpoint));
