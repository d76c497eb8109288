// What `meta` may be: any JSON, but an `id` in it is an id, and the `notes` of a document are texts.
import { describe, expect, it } from "vitest";
import * as schema from "../../generated/validators";
import { check } from "../../shared/messages/check";
import { checkExample } from "../schemas";

/** The parts of a state in which one element of each kind has this `meta`. */
const partsWith = (meta: unknown): readonly object[] => [
  { meta },
  { children: [{ state: "A", meta }] },
  { children: [{ barrier: "B", to: [], meta }] },
  { parameters: [{ name: "a", meta }] },
  { results: [{ name: "r", meta }] },
  { variables: [{ name: "v", meta }] },
  { actions: [{ when: "True", do: "", meta }] },
  { ports: [{ name: "p", when: "True", meta }] },
];
const documentOf = (parts: object, meta: unknown = {}) => ({ rcm: 1, root: { state: "Root", ...parts }, meta });

/** Both by the schema itself and by the validator of the pages. */
function expectRead(document: object): void {
  expect(checkExample("document", document)).toBe(document);
  expect(check(schema.native, { document, origin: {} }).document).toBe(document);
}
function expectRefused(document: object, reason: RegExp): void {
  expect(() => checkExample("document", document), JSON.stringify(document)).toThrow(reason);
  expect(() => check(schema.native, { document, origin: {} }), JSON.stringify(document)).toThrow(reason);
}

describe("meta of an element", () => {
  it.each([null, 7, "text", ["id", 1], {}, { title: "Grasp" }, { id: "A-z_09", min: 1 }, { id: "x".repeat(64) }])("may be %j", (meta) => {
    for (const parts of partsWith(meta)) expectRead(documentOf(parts));
  });
  it.each(["", "x".repeat(65), "a b", "Root/A", "é", 7, null])("has no id %j", (id) => {
    for (const parts of partsWith({ id })) expectRefused(documentOf(parts), /meta\/id: expected/);
  });
});

describe("meta of a document", () => {
  it.each([null, 7, [], { title: "Pick" }, { notes: {} }, { notes: { a: "Take it away." } }])("may be %j", (meta) => expectRead(documentOf({}, meta)));
  it.each([{ notes: { a: 1 } }, { notes: ["a"] }, { notes: "a" }])("is not %j", (meta) => expectRefused(documentOf({}, meta), /meta\/notes/));
});
