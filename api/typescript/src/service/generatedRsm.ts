// The RSM of a class whose operations say in which states the service is meanwhile; the same that ../../../python makes of one.
import { isObject, type JsonObject, type JsonValue } from "../json.js";

/** The first state, and the one in which nothing is busy. */
const kReady = "Ready";

/** An operation as it stands in the RSM, the state that it makes busy, and the one that it stops. */
export interface DeclaredOperation {
  readonly model: JsonObject & { readonly name: string };
  readonly busy: string | undefined;
  readonly stops: string | undefined;
}

/** Of an operation that several states take. */
const transitionId = (operation: string, state: string): string => `${operation}_${state}`;

/** What an event has beside its name, of the type of its data, or of all of it. */
const eventFields = (what: JsonValue): JsonObject => (isObject(what) && Object.hasOwn(what, "data") ? what : { data: what });

/** From the first state to its own, and back when it is done, or stopped. */
function busyTransitions(operation: string, busy: string, operations: readonly DeclaredOperation[]): readonly JsonObject[] {
  const enders = operations.filter(({ stops }) => stops === busy).map(({ model }) => transitionId(model.name, busy));
  const done = `${operation}_done`;
  return [
    { id: operation, src: kReady, dst: busy, operation, defer: [done, ...enders] },
    { id: done, src: busy, dst: kReady },
  ];
}

/** Taken in each state, and answered by itself; one that stops leads back to the first. */
function otherTransitions(operation: string, stops: string | undefined, states: readonly string[]): readonly JsonObject[] {
  return states.map((state) => {
    const ends = state === stops;
    return { id: transitionId(operation, state), src: state, dst: ends ? kReady : state, operation, ...(ends ? { error: "stopped" } : {}) };
  });
}

/** `events`: the type of each, or all of it; each may come in each state. */
export function generatedRsm(name: string, operations: readonly DeclaredOperation[], events: JsonObject): JsonObject {
  const states = [...new Set([kReady, ...operations.flatMap(({ busy }) => (busy === undefined ? [] : [busy]))])];
  const transitions = operations.flatMap(({ model, busy, stops }) =>
    busy === undefined ? otherTransitions(model.name, stops, states) : busyTransitions(model.name, busy, operations),
  );
  const names = Object.keys(events);
  return {
    rsm: 1,
    name,
    operations: operations.map(({ model }) => model),
    events: Object.entries(events).map(([event, what]) => ({ name: event, ...eventFields(what) })),
    states: states.map((state) => ({ name: state, ...(names.length === 0 ? {} : { events: names }) })),
    init: kReady,
    transitions,
  };
}
