// Δ after a step: the snapshot and the delta that the server sends.
import type { CoreDelta, Names, RunState, Values } from "../../generated/messages";
import type { ModelTree } from "../model/modelTree";

function mergeFlags(now: readonly string[], changes: Readonly<Record<string, boolean>>): readonly string[] {
  const kept = now.filter((entry) => changes[entry] !== false);
  const known = new Set(kept);
  return [...kept, ...Object.keys(changes).filter((entry) => changes[entry] === true && !known.has(entry))];
}

function mergeValues(now: Values, set: Values, unset: Names = {}): Values {
  const merged: Record<string, Readonly<Record<string, Values[string][string]>>> = { ...now };
  for (const [path, values] of Object.entries(set)) merged[path] = { ...merged[path], ...values };
  for (const [path, names] of Object.entries(unset)) {
    merged[path] = Object.fromEntries(Object.entries(merged[path] ?? {}).filter(([name]) => !names.includes(name)));
  }
  return Object.fromEntries(Object.entries(merged).filter(([, values]) => Object.keys(values).length > 0));
}

export function applyDelta(state: RunState, delta: CoreDelta): RunState {
  const activated = { ...state.activated, ...delta.activated };
  return {
    active: mergeFlags(state.active, delta.active),
    ports: mergeFlags(state.ports, delta.ports),
    activated: Object.fromEntries(Object.entries(activated).filter(([, ports]) => ports.length > 0)),
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
