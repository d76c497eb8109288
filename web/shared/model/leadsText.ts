// Where a port leads, in words.
import { exitsThrough } from "./exitReferences";
import type { Port } from "./model";
import { nameOf, stateAt, type ModelTree } from "./modelTree";

/** Of a port of the state at `path`: to a sibling, out of the state around, which reads it, out of the task, or nowhere. */
export function leadsText({ name, to }: Pick<Port, "name" | "to">, path: string, tree: ModelTree | undefined): string {
  if (!path.includes("/")) return "Ends the task: the run is over when it fires.";
  const exits = exitsThrough(tree && stateAt(tree, path.slice(0, path.lastIndexOf("/"))), nameOf(path), name);
  const ends = exits.length === 0 ? undefined : `The state around it is left through ${exits.join(" or ")}, which reads it.`;
  if (to !== undefined) return ends === undefined ? `Leads to ${to}.` : `Leads to ${to}. ${ends}`;
  return ends ?? "Leads nowhere, and no port of the state around reads it.";
}
