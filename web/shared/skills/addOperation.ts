// The command by which RACE-Pro adds a state that calls an operation of a service.
import type { RsmOperation } from "../../generated/messages";
import type { KnownService } from "../code/services";
import { addChild } from "../edit/commands/add";
import type { Command, NewId } from "../edit/commands/command";
import type { PlaceOrReason } from "../edit/commands/place";
import { withNewIds } from "../edit/clipboard/paste";
import type { Tree } from "../edit/tree";
import { addService } from "./copy";
import { operationState } from "./operationState";

/** Adds a state that calls the operation, and declares its service, as one change. Requires an operation of offeredOperations(). */
export function addOperation(tree: Tree, place: PlaceOrReason, service: KnownService, operation: RsmOperation, newId: NewId): Command {
  const declared = addService(tree, service.key, service.type);
  if (typeof declared === "string") return { reason: declared };
  const state = withNewIds(operationState(service, operation), newId, new Map());
  const wish = typeof state["state"] === "string" ? state["state"] : "";
  const added = addChild(tree, place, newId(), wish, (name) => ({ ...state, state: name }), true);
  if ("reason" in added || !("operations" in added.change)) return added;
  return { ...added, change: { operations: [...declared, ...added.change.operations] } };
}
