// Giving fields of elements a value.
import type { Exact } from "../exact";
import type { Operation } from "../apply";
import type { Change } from "../session";

type SetOperation = Extract<Operation, { op: "set" }>;

/** The operation that gives a field a value, or takes it away. `value`: as it was written; nothing that was read from the document. */
export const setOperation = (id: string, field: string, value: Exact<SetOperation["value"]> | undefined, key?: string): Exact<SetOperation> => ({
  op: "set", id, field, ...(key !== undefined && { key }), ...(value !== undefined && { value }),
});

/** One field of an element; of the document, with an empty `id`. */
export const setField = (...set: Parameters<typeof setOperation>): Change => ({ operations: [setOperation(...set)] });

/** Another name, also where the element is named: the server finds where. */
export const rename = (id: string, name: string): Change => ({ compound: { kind: "rename", id, name } });
