import { describe, expect, it } from "vitest";
import type { Input } from "../../generated/messages";
import { leasedText, reservedBy, reservedText } from "../../shared/stop/leases";

describe("reserved services", () => {
  it("are told by the run that has them", () => {
    const reserved = reservedBy([{ service: "gripper", core: "3" }, { service: "timer", core: "4" }, { service: "robot", core: "3" }]);
    expect(reserved).toEqual([{ core: "3", services: ["gripper", "robot"] }, { core: "4", services: ["timer"] }]);
    expect(reserved.map(reservedText)).toEqual(["gripper, robot are reserved by", "timer is reserved by"]);
  });
});

describe("a call that was refused because another run has the service", () => {
  const response = (error: unknown): { readonly input: Input } => ({ input: { kind: "response", call: 1, service: "robot", operation: "move", error } as Input });
  const leased = response({ code: "leased", message: "run 3 has `robot` until it is over" });
  it("is told with the run", () => {
    expect(leasedText([{ input: { kind: "start" } }, leased])).toBe("robot.move was refused: run 3 has `robot` until it is over. Only one run at a time moves a service: wait until the other run is over, or end it.");
  });
  it("is none among others", () => {
    expect([leasedText([]), leasedText([{ input: { kind: "start" } }, response({ code: "unreachable" }), response("leased")])]).toEqual([undefined, undefined]);
  });
});
