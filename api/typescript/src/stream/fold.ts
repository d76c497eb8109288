// The state of a run from a snapshot and the deltas after it (api/schemas/core_state.json, core_delta.json). Pure: nothing is changed.
import type { Core, CoreDelta, CoreState } from "../generated/messages.js";
import type { JsonValue } from "../json.js";

type Table = Readonly<Record<string, Readonly<Record<string, JsonValue>>>>;

/** Whether a run with this status is over for good. */
export const isOver = (status: Core["status"]): boolean => status === "ended" || status === "faulted" || status === "aborted";

/** Names that are active now. */
function members(before: readonly string[], changes: Readonly<Record<string, boolean>>): readonly string[] {
  const kept = before.filter((name) => changes[name] !== false);
  const known = new Set(kept);
  return [...kept, ...Object.keys(changes).filter((name) => changes[name] === true && !known.has(name))];
}

/** Path -> name -> value, without those that are set no more. */
function values(before: Table, changes: Table, unset: Readonly<Record<string, readonly string[]>> = {}): Table {
  const after = new Map(Object.entries(before));
  for (const path of new Set([...Object.keys(changes), ...Object.keys(unset)])) {
    const gone = new Set(unset[path]);
    const left = Object.entries({ ...before[path], ...changes[path] }).filter(([name]) => !gone.has(name));
    if (left.length === 0) after.delete(path);
    else after.set(path, Object.fromEntries(left));
  }
  return Object.fromEntries(after);
}

/** What is after a delta. Lists are in the order in which their elements became active; an order of the model is not kept. */
export function fold({ state }: CoreState, delta: CoreDelta): CoreState {
  const { unset } = delta;
  const arrived = Object.entries({ ...state.activated, ...delta.activated }).filter(([, ports]) => ports.length > 0);
  return {
    core: delta.core,
    state: {
      active: members(state.active, delta.active),
      ports: members(state.ports, delta.ports),
      activated: Object.fromEntries(arrived),
      parameters: values(state.parameters, delta.parameters, unset.parameters),
      results: values(state.results, delta.results, unset.results),
      variables: values(state.variables, delta.variables, unset.variables),
    },
  };
}
