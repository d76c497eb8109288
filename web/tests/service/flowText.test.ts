import { describe, expect, it } from "vitest";
import type { JsonValue } from "../../shared/json";
import { flowText } from "../../shared/service/flowText";

const text = (meta: JsonValue) => flowText({ rsm: 1, name: "camera", operations: [], events: [], meta }, "frame");

describe("flowText", () => {
  it("is the description in the RSM", () => expect(text({ flows: { frame: "pictures", cloud: 3 } })).toBe("pictures"));
  it("is nothing where `meta` is used otherwise", () => {
    for (const other of [null, 3, "flows", [], { flows: "all" }, { flows: { frame: 3 } }, { flows: {} }]) expect(text(other)).toBeUndefined();
    expect(flowText({ rsm: 1, name: "camera", operations: [], events: [] }, "frame")).toBeUndefined();
  });
});
