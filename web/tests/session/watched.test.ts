import { describe, expect, it } from "vitest";
import type { Core } from "../../generated/messages";
import { coreToWatch } from "../../shared/session/watched";

const core = (id: string, status: Core["status"]): Core => ({ id, document: "pick", revision: 1, status, paused: false, stepping: false, step: 1, micro: 0, waiting: 0, arguments: {}, breakpoints: [], live: false, model: 0 });
const cores = [core("1", "interrupted"), core("2", "interrupted"), core("3", "running"), core("4", "ended")];

describe("coreToWatch", () => {
  it("is the wanted core, whatever its status", () => expect(coreToWatch(cores, "4")?.id).toBe("4"));
  it("is an interrupted core before one that runs, as it waits for a person", () => expect(coreToWatch(cores, undefined)?.id).toBe("2"));
  it("is the newest that is not over, else the newest, if the wanted one is gone", () => {
    expect(coreToWatch(cores.slice(2), "9")?.id).toBe("3");
    expect(coreToWatch(cores.slice(3), "9")?.id).toBe("4");
    expect(coreToWatch([], "9")).toBeUndefined();
  });
  it("is one of the document that is edited among those that come first, not before them", () => {
    const other = (id: string, status: Core["status"]) => ({ ...core(id, status), document: "place" });
    expect(coreToWatch([core("3", "running"), other("5", "running")], undefined, "pick")?.id).toBe("3");
    expect(coreToWatch([core("4", "ended"), other("5", "running")], undefined, "pick")?.id, "stop reaches what moves").toBe("5");
    expect(coreToWatch([core("4", "ended"), other("5", "ended")], undefined, "pick")?.id).toBe("4");
    expect(coreToWatch([core("3", "running"), other("5", "running")], "5", "pick")?.id).toBe("5");
  });
});
