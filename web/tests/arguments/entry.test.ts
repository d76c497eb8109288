import { describe, expect, it } from "vitest";
import { readExact, writeExact } from "../../shared/edit/exact";
import { expectation, firstText, inputOf, readArguments, readField } from "../../shared/arguments/entry";
import type { Type } from "../../shared/arguments/mismatch";
import { areOptional, runParameters, type ExactDocument, type RunParameter } from "../../shared/arguments/parameters";

const parameter = (type: Type, more: Partial<RunParameter> = {}): RunParameter => ({ name: "x", type, initial: undefined, unit: undefined, doc: undefined, min: undefined, max: undefined, ...more });

/** The argument as it is sent, `-` if there is none, or what is wrong. */
function said(of: RunParameter, text: string): string {
  const reading = readField(of, text);
  if (reading === undefined) return "-";
  return "problem" in reading ? reading.problem : writeExact(reading.value);
}

describe("the parameters of a run", () => {
  const of = (text: string) => runParameters(readExact(text) as unknown as ExactDocument);
  it("are those of the root, with values as they are written", () =>
    expect(of('{"rcm":1,"root":{"state":"R","parameters":[{"name":"speed","value":1.0,"type":"number","unit":"m/s","meta":{"min":0,"max":2.5}},{"name":"part"}]}}')).toEqual([
      { name: "speed", type: "number", initial: "1.0", unit: "m/s", doc: undefined, min: 0, max: 2.5 },
      { name: "part", type: "any", initial: undefined, unit: undefined, doc: undefined, min: undefined, max: undefined },
    ]));
  it("are those of the library state that the root links, where the link says nothing else", () =>
    expect(of('{"rcm":1,"library":[{"state":"L","parameters":[{"name":"a","value":1,"type":"int"},{"name":"b","value":2}]}],"root":{"state":"R","link":"L","parameters":[{"name":"a","value":7}]}}').map(({ name, type, initial }) => [name, type, initial])).toEqual([["a", "int", "7"], ["b", "any", "2"]]));
  it("are optional if each has a value", () => expect([areOptional([]), areOptional([parameter("int", { initial: "1" })]), areOptional([parameter("int")])]).toEqual([true, true, false]));
});

describe("a number", () => {
  it("is sent as it is typed", () => expect(["1.0", "1", "2e3", "0.10", "-3", "9007199254740993"].map((text) => said(parameter("number"), text))).toEqual(["1.0", "1", "2e3", "0.10", "-3", "9007199254740993"]));
  it("must be one", () => expect(["x", "1,5", "", ".5", "NaN", "01"].map((text) => said(parameter("number"), text))).toEqual(["must be a number, such as 0.25", "must be a number, such as 0.25", "needs a value", "must be a number, such as 0.25", "must be a number, such as 0.25", "must be a number, such as 0.25"]));
  it("must be whole for an int, of 64 bits", () => expect(["1.0", "9223372036854775807", "9223372036854775808", "-2"].map((text) => said(parameter("int"), text))).toEqual(["must be a whole number", "9223372036854775807", "must be a whole number", "-2"]));
  it("must be within its bounds", () => expect(["-1", "3", "2.5"].map((text) => said(parameter("number", { min: 0, max: 2.5 }), text))).toEqual(["must be at least 0", "must be at most 2.5", "2.5"]));
  it("that is not changed is not sent", () => expect([said(parameter("number", { initial: "1.0" }), "1.0"), said(parameter("number", { initial: "1.0" }), "1"), said(parameter("number", { initial: "1.0" }), "")]).toEqual(["-", "1", "needs a value"]));
});

describe("a text", () => {
  it("stands without quotes, and is sent with its spaces", () => {
    expect(firstText(parameter("string", { initial: '"a \\"b\\""' }))).toBe('a "b"');
    expect(said(parameter("string"), " 1.0 ")).toBe('" 1.0 "');
  });
  it("may be empty if it has been another", () => expect([said(parameter("string", { initial: '"a"' }), ""), said(parameter("string"), "")]).toEqual(['""', "needs a value"]));
});

it("chooses among true and false, or what the type lists, as it is written there", () => {
  expect(inputOf("bool")).toEqual({ kind: "choice", choices: ["true", "false"] });
  const listed = (readExact('{"enum": [1.0, "a", null]}') as unknown) as Type;
  expect(inputOf(listed)).toEqual({ kind: "choice", choices: ["1.0", '"a"', "null"] });
  expect(said(parameter(listed), "1.0")).toBe("1.0");
  expect(said(parameter("bool"), "")).toBe("needs a value");
});

describe("JSON", () => {
  const pose = '{"position": [0.0, 1, 2.50], "orientation": [0, 0, 0, 1.0]}';
  it.each<[Type, string, string]>([
    ["pose", pose, '{"position":[0.0,1,2.50],"orientation":[0,0,0,1.0]}'],
    ["pose", '{"position": [0, 1], "orientation": [0, 0, 0, 1]}', "position: must be a list of 3 numbers"],
    ["pose", '{"position": [0, 1, 2]}', "the field `orientation` is missing"],
    [{ list: "int" }, "[1, 2.0]", "item 2: must be a whole number"],
    [{ list: "number", size: 2 }, "[1.0]", "must be a list of 2 numbers"],
    [{ record: { a: "int", b: { optional: "string" } } }, '{"a": 1}', '{"a":1}'],
    [{ record: { a: "int" } }, '{"a": 1, "c": 2}', "there is no field `c`"],
    [{ optional: "number" }, "null", "null"],
    [{ optional: "number" }, "1.0", "1.0"],
    [{ optional: "number" }, '"a"', "must be a number"],
    ["image", '{"width": 2, "height": 3, "data": ""}', '{"width":2,"height":3,"data":""}'],
    ["null", "1", "must be null"],
    ["any", "{", 'is not JSON, such as {"a": [1, 0.5, "text"]}'],
    ["any", "[1.0, {}]", "[1.0,{}]"],
  ])("of type %j: %s", (type, text, expected) => expect(said(parameter(type), text)).toBe(expected));
});

describe("a form", () => {
  const parameters = [parameter("int", { name: "n", initial: "3" }), parameter("number", { name: "v" })];
  it("says all arguments that were changed", () => expect(writeExact(readArguments(parameters, { v: "1.0" }))).toBe('{"values":{"v":1.0}}'));
  it("says what is wrong at each field", () => expect(readArguments(parameters, { n: "x" })).toEqual({ problems: { n: "must be a whole number, such as 3", v: "needs a value" } }));
  it("tells what a field expects", () => expect([expectation(parameter("number", { unit: "m", min: 0, max: 2 })), expectation(parameter({ optional: "int" })), expectation(parameter("int", { max: 9 }))]).toEqual(["a number, in m, 0 to 2", "a whole number, or null", "a whole number, at most 9"]));
});
