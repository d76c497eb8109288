// Where breakpoints are in a model, and what they and their places are called.
import type { Breakpoint, Core, CoreBreakpoint, KeptBreakpoint, When } from "../../generated/messages";
import { elementsById, type ElementsById } from "../model/byId";
import { idAt, selectionsOf, type Selection } from "../model/identity";
import { portAddress } from "../model/model";
import { nameOf, splitAddress, stateAt, type ModelTree } from "../model/modelTree";
import { selectionAt } from "../session/view";
import type { Where } from "./breakpoints";

type AnyBreakpoint = Breakpoint | KeptBreakpoint;

const known = new WeakMap<ModelTree, ElementsById>();

function byId(tree: ModelTree): ElementsById {
  const before = known.get(tree);
  const made = before ?? elementsById(tree);
  if (before === undefined) known.set(tree, made);
  return made;
}

/** How a breakpoint names what is selected. */
export function whereOf(tree: ModelTree, selection: Selection): Where {
  const id = idAt(tree, selection);
  return id === undefined ? { path: selection.kind === "node" ? selection.path : selection.address } : { id };
}

/** The node or port that a breakpoint is at, of an action its state; nothing: the model has none, or it is of the whole task. */
export function selectionOf(tree: ModelTree, { id, path }: AnyBreakpoint): Selection | undefined {
  if (id === undefined) return path === undefined ? undefined : selectionAt(tree, path);
  const found = selectionsOf(tree).get(id);
  const element = found === undefined ? byId(tree).get(id) : undefined;
  return found ?? (element && { kind: "node", path: element.path });
}

/** What a breakpoint is at, in a word or two. */
export function placeText(tree: ModelTree | undefined, { id, path }: AnyBreakpoint): string {
  if (id === undefined) return path === undefined ? "the whole task" : nameOf(path);
  const element = tree && byId(tree).get(id);
  if (element === undefined) return "what is not here";
  switch (element.kind) {
    case "port":
      return nameOf(portAddress(element.path, element.element));
    case "action": {
      const at = (tree && stateAt(tree, element.path)?.actions.indexOf(element.element)) ?? 0;
      return `action ${at + 1} of ${nameOf(element.path)}`;
    }
    default:
      return nameOf(element.path);
  }
}

/** The kinds of breakpoints at a state, and at a port, the usual one first. */
export const kOfState: readonly When[] = ["entered", "left", "into", "executed", "called", "fault", "fulfilled"];
export const kOfPort: readonly When[] = ["fired", "tested"];

export const whenTexts: Readonly<Record<When, string>> = {
  entered: "entered", left: "left", into: "anything in it entered", fired: "fired", tested: "tested", executed: "executed", called: "calls", fault: "faults", fulfilled: "fulfilled",
};

/** What each kind waits for, in a sentence without its subject. */
export const whenTitles: Readonly<Record<When, string>> = {
  entered: "the state is entered", left: "the state is left", into: "a state in it is entered, or it is left", fired: "the port fires", tested: "the condition of the port is evaluated",
  executed: "an action is executed", called: "an operation is called", fault: "the run faults there", fulfilled: "the condition becomes fulfilled while the state is active",
};

const operationText = ({ service, operation }: AnyBreakpoint): string => (service === undefined && operation === undefined ? "" : ` ${service ?? "any"}.${operation ?? "any operation"}`);

/** `Grasp.success, tested`: where, and when; what else has to hold is not said. */
export const breakpointText = (tree: ModelTree | undefined, breakpoint: AnyBreakpoint): string =>
  `${placeText(tree, breakpoint)}, ${breakpoint.before === true && breakpoint.when !== "fault" ? "before: " : ""}${whenTexts[breakpoint.when]}${operationText(breakpoint)}`;

/** The breakpoints at which a core is paused. */
export const reachedBy = ({ breakpoints, reached, paused }: Core): readonly CoreBreakpoint[] =>
  paused ? (reached ?? []).map((i) => breakpoints[i]).filter((each): each is CoreBreakpoint => each !== undefined) : [];

export interface BreakpointMark {
  /** Path of a node, or address of a port. */
  readonly address: string;
  /** One of those there is enabled. */
  readonly on: boolean;
  /** What is there, for the pointer and for who hears it. */
  readonly text: string;
}

/** The breakpoints in a model, one mark for each node and port that has some. */
export function breakpointMarks(tree: ModelTree, breakpoints: readonly KeptBreakpoint[]): ReadonlyMap<string, BreakpointMark> {
  const marks = new Map<string, BreakpointMark>();
  for (const breakpoint of breakpoints) {
    const selection = selectionOf(tree, breakpoint);
    if (selection === undefined) continue;
    const address = selection.kind === "node" ? selection.path : selection.address;
    const before = marks.get(address);
    const text = `${breakpoint.enabled ? "" : "disabled: "}${breakpointText(tree, breakpoint)}`;
    marks.set(address, { address, on: before?.on === true || breakpoint.enabled, text: before === undefined ? `Breakpoint: ${text}` : `${before.text}; ${text}` });
  }
  return marks;
}

/** So many of the breakpoints within a state are told one by one. */
const kTold = 3;

function joined(path: string, all: readonly BreakpointMark[]): BreakpointMark | undefined {
  if (all.length < 2) return all[0];
  const more = all.length > kTold ? `; ${all.length - kTold} more` : "";
  return { address: path, on: all.some(({ on }) => on), text: all.slice(0, kTold).map(({ text }) => text).join("; ") + more };
}

const nodeOf = ({ address }: BreakpointMark): string => splitAddress(address)?.path ?? address;

/** Of the ports of a state, and of itself: for a row that stands for all of it. `closed`: also of all within it, which are not shown. */
export const markOfState = (marks: ReadonlyMap<string, BreakpointMark>, path: string, closed = false): BreakpointMark | undefined =>
  joined(path, [...marks.values()].filter((mark) => nodeOf(mark) === path || (closed && nodeOf(mark).startsWith(`${path}/`))));

/** Of a state that is drawn closed: of itself, and of all within it. Its ports are drawn, and have their own. */
export const markOfClosed = (marks: ReadonlyMap<string, BreakpointMark>, path: string): BreakpointMark | undefined =>
  joined(path, [...marks.values()].filter((mark) => mark.address === path || nodeOf(mark).startsWith(`${path}/`)));
