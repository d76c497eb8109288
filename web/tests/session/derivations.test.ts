import { describe, expect, it } from "vitest";
import type { Core } from "../../generated/messages";
import type { RcmDocument } from "../../shared/model/model";
import { derivationsWanted } from "../../shared/session/derivations";
import { emptySession, type Session } from "../../shared/session/session";
import type { View } from "../../shared/session/view";

const core = (fields: Partial<Core> = {}) => ({ id: "3", status: "running", paused: false, ...fields }) as Core;
const task = (entry: string): RcmDocument => ({ name: "task", services: {}, library: [], root: { kind: "state", name: "Root", entry, parameters: [], results: [], variables: [], actions: [], children: [], ports: [] } });
const session = (one: Core, more: Partial<Session> = {}): Session => ({ ...emptySession, cores: [one], watched: "3", model: task("svc.robot.move(p)"), ...more });
const closed: Pick<View, "drawer" | "selection" | "asked"> = { drawer: "closed", selection: undefined, asked: undefined };

describe("derivations of a run", () => {
  it("are not wanted while it runs and nothing shows them", () => {
    expect(derivationsWanted(session(core()), closed)).toBeUndefined();
    expect(derivationsWanted(session(core()), { ...closed, drawer: "log" })).toBeUndefined();
    expect(derivationsWanted(session(core()), { ...closed, selection: { kind: "node", path: "Root" } })).toBeUndefined();
  });
  it("are wanted where they are shown, or a port is asked why it fired", () => {
    expect(derivationsWanted(session(core()), { ...closed, drawer: "derivation" })).toBe("3");
    expect(derivationsWanted(session(core()), { ...closed, selection: { kind: "port", address: "Root.done" } })).toBe("3");
    expect(derivationsWanted(session(core()), { ...closed, selection: { kind: "node", path: "Root" }, asked: { action: 0 } })).toBe("3");
  });
  it("are wanted while the run stands, as then few come", () => {
    for (const one of [core({ paused: true }), core({ status: "ended" }), core({ status: "interrupted" }), core({ status: "ready" })]) expect(derivationsWanted(session(one), closed)).toBe("3");
  });
  it("are not wanted of a task that asks people, whose questions come with its state, nor while its model is loading", () => {
    expect(derivationsWanted(session(core(), { model: task("svc.phone.ask('Go on?')") }), closed)).toBeUndefined();
    expect(derivationsWanted(session(core(), { model: undefined }), closed)).toBeUndefined();
  });
  it("are not wanted of a run that no core hosts", () => expect(derivationsWanted({ ...session(core()), watched: "4" }, { ...closed, drawer: "derivation" })).toBeUndefined());
});
