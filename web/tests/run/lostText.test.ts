import { describe, expect, it } from "vitest";
import type { Core } from "../../generated/messages";
import { lastStatusText, lostText } from "../../shared/run/lostText";
import { applyEvent, commandable, emptySession } from "../../shared/session/session";

const core: Core = { id: "7", document: "pick", revision: 3, status: "running", paused: false, stepping: false, step: 12, micro: 0, waiting: 0, arguments: {}, breakpoints: [], live: false, model: 0 };

describe("a lost server", () => {
  it("says where the run was, and that the robot is out of reach", () => {
    expect(lostText(core).title).toBe("Server lost at step 12 of run 7: pause and stop cannot reach the robot");
    expect(lostText({ ...core, micro: 3, paused: true }).title).toBe("Server lost at step 12, micro step 3 of run 7: pause and stop cannot reach the robot");
  });
  it("says nothing of the robot where no run may move it", () => {
    expect(lostText(core, true).title).toBe("The server has ended; run 7 was at step 12");
    expect(lostText(undefined, true).title).toBe("The server has ended");
    for (const status of ["ready", "ended", "faulted", "aborted"] as const) expect(lostText({ ...core, status }).title).toBe("Server lost");
    expect(lostText(undefined).title).toBe("Server lost");
  });
  it("leaves the status open of a run that may have gone on", () => {
    expect(lastStatusText(core)).toBe("Not known; last: Running");
    expect(lastStatusText({ ...core, status: "ended", outcome: "done" })).toBe("Ended: done");
  });
  it("is lost until it answers, and takes no commands meanwhile", () => {
    const watching = { ...emptySession, connection: "open", cores: [core], watched: "7" } as const;
    expect(commandable(watching)).toBe(core);
    const lost = applyEvent(watching, { type: "connection", connection: "lost" });
    const trying = applyEvent(lost, { type: "connection", connection: "connecting" });
    expect([trying.connection, commandable(trying)]).toEqual(["lost", undefined]);
    expect(commandable(applyEvent(trying, { type: "connection", connection: "open" }))).toBe(core);
  });
});
