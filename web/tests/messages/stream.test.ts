import { describe, expect, it } from "vitest";
import { readStreamMessage } from "../../shared/messages/stream";
import { reconnectDelay, resubscriptions } from "../../shared/stream";

const message = (channel: string, kind: string, data: unknown) => readStreamMessage({ channel, sequence: 7, kind, data });

describe("readStreamMessage", () => {
  it("distinguishes the state of a core from its derivation by the channel", () => {
    expect(message("core/12/derivation", "snapshot", { next: 4 }).update).toEqual({ type: "derivation_position", id: "12", next: 4 });
  });
  it("reads the removal of a core", () => {
    expect(message("cores", "delta", { removed: "3" }).update).toEqual({ type: "core_removed", id: "3" });
  });
  it("reads a refusal of any channel", () => {
    const data = { errors: [{ path: "", code: "not_found", message: "no core 9" }] };
    expect(message("core/9/state", "error", data).update).toMatchObject({ type: "refused", channel: "core/9/state" });
  });
  it("reads what a display shows, whole in every message", () => {
    const number = { unit: "m", min: 0, max: 1 };
    const data = { display: "left", question: { id: 3, text: "How wide?", number } };
    for (const kind of ["snapshot", "delta"])
      expect(message("display/left", kind, data).update).toEqual({
        type: "display",
        content: { display: "left", question: { id: 3, text: "How wide?", number } },
      });
    expect(() => message("display/left", "delta", { display: "left", question: { id: 3, text: "Go?" } })).toThrow("/data/question/buttons");
  });
  it("reads the header of a packet, and a picture if there is one", () => {
    const cloud = { time: 1.5, header: { points: 3, encoding: "xyz32f_m+rgb8" } };
    expect(message("flow/camera/cloud", "delta", cloud).update).toEqual({ type: "packet", channel: "flow/camera/cloud", packet: cloud });
    const picture = { width: 1, height: 1, depth: "AAA=", colour: "AAAA" };
    expect(message("flow/camera/frame", "delta", { ...cloud, picture }).update).toMatchObject({ packet: { picture } });
  });
  it("refuses a channel that the contract does not have", () => {
    expect(() => message("weather", "snapshot", {})).toThrow("/channel");
  });
});

describe("the stream after a lost connection", () => {
  it("asks for what it missed of the channels it knows, and for the whole of the others", () => {
    expect(resubscriptions(new Set(["cores", "log"]), new Map([["log", 41]]))).toEqual([
      { type: "gather" },
      { type: "subscribe", channel: "cores" },
      { type: "subscribe", channel: "log", since: 41 },
    ]);
  });
  it("waits longer after each failure, but never more than eight seconds", () => {
    expect([0, 1, 2, 9].map(reconnectDelay)).toEqual([500, 1000, 2000, 8000]);
  });
});
