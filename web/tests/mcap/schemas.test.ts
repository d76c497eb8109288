import { Ajv2020 } from "ajv/dist/2020.js";
import { describe, expect, it } from "vitest";
import { kSchemas, type Field } from "../../shared/mcap/schemas";
import { strict } from "./readBack";

/** What Foxglove cannot read of a schema: it knows objects with properties, and arrays of objects or simple values. */
function unreadable(field: Field, path: string): readonly string[] {
  if (field.type === "object") return field.properties === undefined ? [path] : Object.entries(field.properties).flatMap(([name, each]) => unreadable(each, `${path}.${name}`));
  if (field.type !== "array") return [];
  return field.items === undefined || field.items.type === "array" || field.items.contentEncoding !== undefined ? [path] : unreadable(field.items, `${path}[]`);
}

describe("the schemas of a file", () => {
  it.each(Object.entries(kSchemas))("%s is one that Foxglove reads, of an object with a time", (name, schema) => {
    expect(schema.type).toBe("object");
    expect(schema.title).toBe(name);
    expect(unreadable(schema, name)).toEqual([]);
    expect(name === "foxglove.FrameTransforms" || schema.required?.includes("timestamp")).toBe(true);
  });
  it("refuse what is missing, more, or of another type", () => {
    const check = new Ajv2020().compile(strict(kSchemas["foxglove.JointStates"]));
    const timestamp = { sec: 1, nsec: 0 };
    expect(check({ timestamp, joints: [{ name: "a1", position: 0.5 }] })).toBe(true);
    expect(check({ timestamp, joints: [{ name: "a1" }] })).toBe(false);
    expect(check({ timestamp, joints: [{ name: "a1", position: "0.5" }] })).toBe(false);
    expect(check({ timestamp, joints: [], more: 1 })).toBe(false);
    expect(check({ timestamp: { sec: 1, nsec: 1e9 }, joints: [] })).toBe(false);
  });
});
