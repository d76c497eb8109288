import { describe, expect, it } from "vitest";
import { fieldText } from "../../shared/documents/entryText";

describe("fieldText", () => {
  it("gives a field as it is written, so that no number changes", () => {
    const document = '{"rcm": 1, "root": {"value": 1.0, "big": 12345678901234567890, "text": "}, \\"document\\": 2", "list": [1, {"a": []}]}}';
    expect(fieldText(`{"name":"pick","revision":3,"errors":[],"document": ${document} }`, "document")).toBe(document);
    expect(fieldText(`{"document":${document},"name":"pick"}`, "document")).toBe(document);
  });
  it("looks at fields of the object itself alone, not at values and inner fields", () => {
    expect(fieldText('{"message":"document","origin":{"document":1},"list":["document",{"document":2}],"document":{}}', "document")).toBe("{}");
    expect(fieldText('{"message":"document","origin":{"document":1}}', "document")).toBeUndefined();
  });
  it("gives any value", () => {
    const text = '{"a" : -1.5e3 , "b":"x, y","c":null,"d":[ 1 , 2 ],"\\u0065":true}';
    expect(["a", "b", "c", "d", "e"].map((field) => fieldText(text, field))).toEqual(["-1.5e3", '"x, y"', "null", "[ 1 , 2 ]", "true"]);
  });
});
