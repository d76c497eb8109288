import { describe, expect, it } from "vitest";
import type { Control } from "../../generated/messages";
import { applyStop, isStopped, kFirstStop, viewOf, type StopEvent } from "../../shared/stop/state";

const free: Control = { stopped: null, mode: "execution", holder: null, request: null, leases: [{ service: "robot", core: "1" }], stop_ports: [] };
const stopped: Control = { ...free, stopped: { by: "alice", time: 7 }, leases: [] };
const after = (...events: readonly StopEvent[]) => events.reduce(applyStop, kFirstStop);
const view = (...events: readonly StopEvent[]) => viewOf(after(...events));
const told = (control: Control): StopEvent => ({ type: "told", control });

describe("what a page says of the stop", () => {
  it("is nothing before the server has told, then what it tells", () => {
    expect([view(), view(told(free)), view(told(stopped)), view(told(stopped), told(free))]).toEqual(["unknown", "free", "stopped", "free"]);
  });

  it("is that a stop is under way, late, and given up", () => {
    expect([view(told(free), { type: "pressed" }), view({ type: "pressed" }, { type: "late" }), view({ type: "pressed" }, { type: "late" }, { type: "failed" })]).toEqual(["sending", "late", "failed"]);
  });

  it("stays that it failed while the server tells of a cell that is free, until it is read, sent again, or the cell is stopped", () => {
    const failed: readonly StopEvent[] = [{ type: "pressed" }, { type: "failed" }];
    expect([view(...failed, told(free)), view(...failed, { type: "lost" })]).toEqual(["failed", "failed"]);
    expect([view(...failed, { type: "read" }), view(...failed, { type: "pressed" }), view(...failed, told(stopped))]).toEqual(["unknown", "sending", "stopped"]);
  });

  it("is that the cell is stopped as soon as the stop is answered, and by whom when that is told", () => {
    const answered: readonly StopEvent[] = [told(free), { type: "pressed" }, { type: "answered", time: 5 }];
    expect(after(...answered)).toMatchObject({ stopped: { time: 5 }, leases: [], sent: "no" });
    expect(after(...answered, told(stopped)).stopped).toEqual({ by: "alice", time: 7 });
    expect(after(told(stopped), { type: "pressed" }, { type: "answered", time: 9 }).stopped, "who was first is told").toEqual({ by: "alice", time: 7 });
  });

  it("is no time that nobody knows", () => {
    expect(after(told({ ...stopped, stopped: { by: "alice", time: 0 } })).stopped).toEqual({ by: "alice" });
  });

  it("is, without the server, that it stood; but not that it is free, nor what runs have reserved", () => {
    expect(isStopped(after(told(stopped), { type: "lost" }))).toBe(true);
    expect(after(told(free), { type: "lost" })).toMatchObject({ stopped: undefined, leases: [] });
  });

  it("is who has the controls, as long as the server is there, and whether this page has them", () => {
    const holder = { number: 3, by: "bob" };
    const known = after(told({ ...free, mode: "programming", holder, request: { id: 1, by: "eve" } }), { type: "held", number: 2 });
    expect(known).toMatchObject({ mode: "programming", holder, request: { id: 1, by: "eve" }, held: 2 });
    expect(applyStop(known, { type: "lost" })).toMatchObject({ mode: undefined, holder: null, request: null, held: 2 });
    expect(applyStop(known, { type: "held", number: undefined }).held).toBeUndefined();
  });

  it("is nothing of a stop that a reset took back, or that failed after its answer", () => {
    expect(view({ type: "pressed" }, { type: "withdrawn" })).toBe("unknown");
    expect(view({ type: "pressed" }, { type: "answered", time: 5 }, { type: "late" }, { type: "failed" })).toBe("stopped");
  });
});
