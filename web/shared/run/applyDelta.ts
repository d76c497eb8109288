// Δ after a step: the snapshot and the delta that the server sends.
import type { CoreDelta, Names, RunState, Values } from "../../generated/messages";
import type { ModelTree } from "../model/modelTree";

const isEmpty = (changes: object): boolean => Object.keys(changes).length === 0;

function mergeFlags(now: readonly string[], changes: Readonly<Record<string, boolean>>): readonly string[] {
  if (isEmpty(changes)) return now;
  const kept = now.filter((entry) => changes[entry] !== false);
  const known = new Set(kept);
  return [...kept, ...Object.keys(changes).filter((entry) => changes[entry] === true && !known.has(entry))];
}

/** The table with these changes; an entry that they leave empty goes. What did not change is the same object. */
function mergeTable<T extends object>(now: Readonly<Record<string, T>>, changes: Readonly<Record<string, T>>): Readonly<Record<string, T>> {
  if (isEmpty(changes)) return now;
  const merged: Record<string, T> = { ...now, ...changes };
  // A table without them, made of its entries, would cost three times as much.
  for (const key of Object.keys(changes)) if (isEmpty(changes[key] ?? {})) Reflect.deleteProperty(merged, key);
  return merged;
}

function mergeValues(now: Values, set: Values, unset: Names = {}): Values {
  const changes: Record<string, Values[string]> = {};
  for (const [path, values] of Object.entries(set)) changes[path] = { ...now[path], ...values };
  for (const [path, names] of Object.entries(unset)) {
    changes[path] = Object.fromEntries(Object.entries(changes[path] ?? now[path] ?? {}).filter(([name]) => !names.includes(name)));
  }
  return mergeTable(now, changes);
}

export function applyDelta(state: RunState, delta: CoreDelta): RunState {
  return {
    active: mergeFlags(state.active, delta.active),
    ports: mergeFlags(state.ports, delta.ports),
    activated: mergeTable(state.activated, delta.activated),
    parameters: mergeValues(state.parameters, delta.parameters, delta.unset.parameters),
    results: mergeValues(state.results, delta.results, delta.unset.results),
    variables: mergeValues(state.variables, delta.variables, delta.unset.variables),
  };
}

/** What is running now, for the list with a jump: the active nodes without an active child, in tree order. */
export function runningNow(state: RunState, tree: ModelTree): readonly string[] {
  const active = new Set(state.active);
  return [...tree.values()]
    .filter((entry) => active.has(entry.path) && !entry.children.some((child) => active.has(child.path)))
    .map((entry) => entry.path);
}
