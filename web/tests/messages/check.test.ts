import { describe, expect, it } from "vitest";
import * as schema from "../../generated/validators";
import { check, SchemaError } from "../../shared/messages/check";

const core = { id: "1", document: "pick", revision: 3, status: "ready", paused: false, stepping: false, step: 0, micro: 0, waiting: 0, arguments: {}, breakpoints: [], live: false, model: 0 };

describe("check", () => {
  it("gives the value itself", () => expect(check(schema.core, core)).toBe(core));
  it("accepts fields that the schema does not have, as a newer server may send them", () => {
    expect(check(schema.core, { ...core, colour: "green" })).toMatchObject(core);
  });
  it("names the place of a mismatch, below that of the message", () => {
    const two = { cores: [core, { ...core, step: "2" }] };
    expect(() => check(schema.cores, two, "/data")).toThrow(new SchemaError("/data/cores/1/step", "integer", "2"));
  });
  it("names a missing field", () => {
    expect(() => check(schema.health, { version: "1" })).toThrow("/status: expected a value, got undefined");
    expect(() => check(schema.health, null)).toThrow("/: expected object, got null");
  });
  it("lists the words that a field may have", () => {
    const envelope = { channel: "log", sequence: 1, kind: "change", data: {} };
    expect(() => check(schema.envelope, envelope)).toThrow('/kind: expected "snapshot" | "delta" | "edit_accepted" | "edit_refused" | "joined" | "error", got string');
  });
  it("of alternatives checks the one that is meant", () => {
    const steps = (input: object) => () => check(schema.derivationSteps, { steps: [{ step: 1, input, micro: [], calls: [] }] });
    expect(steps({ kind: "miracle" })).toThrow("/steps/0/input/kind: expected a known kind, got string");
    expect(steps({ kind: "event", service: "s", data: 0 })).toThrow("/steps/0/input/event: expected a value, got undefined");
  });
  it("where no field tells alternatives apart, names what they expect at the deepest place", () => {
    expect(() => check(schema.coresDelta, { core: { ...core, step: "2" } })).toThrow("/core/step: expected integer, got string");
    expect(() => check(schema.display, { display: "left", question: { id: 1, text: "Go?" } })).toThrow("/question/buttons: expected a value");
  });
  it("says what other limits a value breaks", () => {
    const pose = { position: [0, 0], orientation: [0, 0, 0, 1] };
    expect(() => check(schema.cellPose, { time: 0, joints: {}, bodies: { "a/b": pose } })).toThrow("/bodies/a~1b/position: expected minItems 3, got array");
    const body = { name: "b", shape: { sphere: 1 }, pose: { ...pose, position: [0, 0, 0] }, fixed: true, colour: "red" };
    expect(() => check(schema.scene, { robots: [], bodies: [body] })).toThrow("/bodies/0/colour: expected pattern ^#");
  });
});
