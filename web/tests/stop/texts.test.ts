import { describe, expect, it } from "vitest";
import { stoppedText, warningText } from "../../shared/stop/texts";

const at = (day: number, hour: number): number => new Date(2026, 2, day, hour, 3, 5).getTime();

describe("who stopped the cell", () => {
  it("is told with the time, and the day of another one", () => {
    expect(stoppedText({ by: "alice", time: at(12, 14) }, at(12, 23))).toBe("STOPPED by alice at 14:03:05");
    expect(stoppedText({ by: "somebody at 127.0.0.1", time: at(12, 0) }, at(13, 1))).toBe("STOPPED by somebody at 127.0.0.1 on 12 Mar 2026 at 00:03:05");
  });
  it("is left out as far as it is not known", () => {
    expect(stoppedText({ by: "alice" }, 0)).toBe("STOPPED by alice");
    expect(stoppedText({ time: at(12, 14) }, at(12, 14))).toBe("STOPPED at 14:03:05");
    expect(stoppedText({}, 0)).toBe("STOPPED");
  });
});

describe("a warning", () => {
  it("is given where a stop may not have come through, and names the robot's own", () => {
    for (const view of ["late", "failed"] as const) expect(warningText(view)?.act).toContain("the robot's own emergency stop");
    expect(warningText("failed")?.title).toBe("STOP did NOT reach the server.");
    for (const view of ["unknown", "free", "stopped", "sending"] as const) expect(warningText(view)).toBeUndefined();
  });
});
