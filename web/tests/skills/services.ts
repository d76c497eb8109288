// Services for tests of states that call their operations.
import type { RsmOperation } from "../../generated/messages";
import type { KnownService } from "../../shared/code/services";

export const serviceOf = (key: string, operations: readonly RsmOperation[], type = key): KnownService => ({ key, type, rsm: { rsm: 1, name: type, operations, events: [] } });

/** As api/templates/gripper_python/gripper.py says it. */
export const gripper = serviceOf("my_gripper", [
  { name: "move", moves: true, parameters: [{ name: "width", type: "number", unit: "m", min: 0, max: 0.11 }] },
  { name: "stop", safe: true, doc: "The fingers stay where they are." },
  { name: "get", reads: true, result: { record: { width: "number" } } },
]);

/** The first operation of a service. Throws if it has none. */
export function firstOf({ rsm }: KnownService): RsmOperation {
  const [operation] = rsm.operations;
  if (operation === undefined) throw new Error("it has no operation");
  return operation;
}
