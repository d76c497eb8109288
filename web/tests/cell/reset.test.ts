import { describe, expect, it } from "vitest";
import type { Core } from "../../generated/messages";
import { refusalToReset } from "../../shared/cell/reset";

const core: Core = { id: "7", document: "pick", revision: 3, status: "running", paused: false, stepping: false, step: 12, micro: 0, waiting: 0, arguments: {}, breakpoints: [], live: false, model: 0 };

describe("a reset of the cell", () => {
  it("is refused under a run that has begun and is not over", () => {
    for (const status of ["running", "interrupted"] as const) expect(refusalToReset([{ ...core, id: "6", status: "ended" }, { ...core, status }])).toBe("run 7 of pick is not over; stop it before the cell is reset");
  });
  it("is possible beside runs that have not begun, or are over", () => {
    expect(refusalToReset((["ready", "ended", "faulted", "aborted"] as const).map((status) => ({ ...core, status })))).toBeUndefined();
  });
});
