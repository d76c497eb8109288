// Δ after a step: the snapshot and the delta that the server sends.
import type { CoreDelta, Names, Values } from "../../generated/messages";
import type { JsonValue } from "../json";
import type { ModelTree } from "../model/modelTree";
import type { LiveState, ValueTable } from "./liveState";

const isEmpty = (changes: object): boolean => Object.keys(changes).length === 0;

function mergeFlags(now: readonly string[], changes: Readonly<Record<string, boolean>>): readonly string[] {
  if (isEmpty(changes)) return now;
  const kept = now.filter((entry) => changes[entry] !== false);
  const known = new Set(kept);
  return [...kept, ...Object.keys(changes).filter((entry) => changes[entry] === true && !known.has(entry))];
}

/** What has arrived at barriers, with these changes; a barrier at which nothing has arrived any more goes. */
function mergeArrived(now: LiveState["activated"], changes: LiveState["activated"]): LiveState["activated"] {
  if (isEmpty(changes)) return now;
  return Object.fromEntries(Object.entries({ ...now, ...changes }).filter(([, arrived]) => arrived.length > 0));
}

function mergeValues(now: ValueTable, set: Values, unset: Names = {}): ValueTable {
  const changes = new Map<string, Readonly<Record<string, JsonValue>>>();
  for (const [path, values] of Object.entries(set)) changes.set(path, { ...now.get(path), ...values });
  for (const [path, names] of Object.entries(unset)) {
    changes.set(path, Object.fromEntries(Object.entries(changes.get(path) ?? now.get(path) ?? {}).filter(([name]) => !names.includes(name))));
  }
  return now.with([...changes].map(([path, values]) => [path, isEmpty(values) ? undefined : values]));
}

export function applyDelta(state: LiveState, delta: CoreDelta): LiveState {
  return {
    active: mergeFlags(state.active, delta.active),
    ports: mergeFlags(state.ports, delta.ports),
    activated: mergeArrived(state.activated, delta.activated),
    parameters: mergeValues(state.parameters, delta.parameters, delta.unset.parameters),
    results: mergeValues(state.results, delta.results, delta.unset.results),
    variables: mergeValues(state.variables, delta.variables, delta.unset.variables),
  };
}

/** What is running now, for the list with a jump: the active nodes without an active child, in tree order. */
export function runningNow(state: Pick<LiveState, "active">, tree: ModelTree): readonly string[] {
  const active = new Set(state.active);
  return [...tree.values()]
    .filter((entry) => active.has(entry.path) && !entry.children.some((child) => active.has(child.path)))
    .map((entry) => entry.path);
}
