// Δ of a run as the page holds it: like the state that the server sends, with tables that change at a small cost.
import type { RunState, Values } from "../../generated/messages";
import type { JsonValue } from "../json";
import { Table } from "./table";

/** The values of each node, by the node's path. */
export type ValueTable = Table<Readonly<Record<string, JsonValue>>>;

export interface LiveState extends Omit<RunState, "parameters" | "results" | "variables"> {
  readonly parameters: ValueTable;
  readonly results: ValueTable;
  readonly variables: ValueTable;
}

const table = (values: Values): ValueTable => Table.of(Object.entries(values));
const known = new WeakMap<RunState, LiveState>();

/** The same object for the same state. */
export function liveState(state: RunState): LiveState {
  const before = known.get(state);
  const read = before ?? { ...state, parameters: table(state.parameters), results: table(state.results), variables: table(state.variables) };
  if (before === undefined) known.set(state, read);
  return read;
}
