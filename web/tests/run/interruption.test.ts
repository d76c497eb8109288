import { describe, expect, it } from "vitest";
import type { Core } from "../../generated/messages";
import * as schema from "../../generated/validators";
import { check } from "../../shared/messages/check";
import { allowed, isOver, primary, statusText } from "../../shared/run/controls";
import { interruptedElsewhere, interruptionText } from "../../shared/run/interruption";
import { commandOf } from "../../shared/session/shortcuts";
import { readJson } from "../files";

const core = check(schema.core, readJson(new URL("../../../api/examples/core.interrupted.json", import.meta.url)));
const running: Core = { ...core, status: "running", paused: false };

describe("an interrupted core", () => {
  it("is called so, is not over, and takes resume, steps and stop, but no pause", () => {
    expect([statusText(core), isOver(core)]).toEqual(["Interrupted", false]);
    expect([...allowed(core)].sort()).toEqual(["macro", "micro", "resume", "stop", "until"]);
  });
  it("is resumed by the first button and its key", () => {
    expect([primary(core), commandOf("lead", core), commandOf("pause", core)]).toEqual(["resume", "resume", undefined]);
  });
});

describe("interruptionText", () => {
  it("says nothing of a core that is not interrupted", () => expect(interruptionText(running)).toBeUndefined());
  it("says after a restart what the server says, and that open calls were answered", () => {
    const text = interruptionText(core);
    expect(text?.title).toBe("Run 1 is interrupted: the server ended and was started again");
    expect(text?.happened).toBe(core.interruption?.message);
    expect(text?.holds).toMatch(/^Open calls were answered `unavailable`.*Nothing moves until someone resumes/);
  });
  it("says of a failing disk that it refuses to go on", () => {
    const text = interruptionText({ ...core, interruption: { reason: "storage", message: "no space left" } });
    expect(text?.title).toContain("its journal cannot be stored");
    expect(text?.happened).toBe("no space left");
    expect(text?.holds).toMatch(/Open calls are answered `unavailable`.*Nothing moves until someone resumes.*while the disk fails, that is refused/);
  });
  it("says of a step that failed that it is not stored", () => {
    const text = interruptionText({ ...core, interruption: { reason: "failure", message: "no memory" } });
    expect(text?.title).toContain("a step of it failed");
    expect(text?.happened).toBe("no memory");
  });
  it.each(["deadline", "stopped"] as const)("says of a macro step that did not end (%s) that its input is gone", (reason) => {
    const text = interruptionText({ ...core, interruption: { reason, message: "10 s" } });
    expect(text?.title).toContain("a macro step did not end");
    expect(text?.holds).toContain("whose input is gone");
  });
  it("says of too many inputs that they are gone", () => {
    const text = interruptionText({ ...core, interruption: { reason: "overload", message: "more wait" } });
    expect(text?.title).toContain("more inputs waited");
    expect(text?.holds).toContain("the inputs that waited are gone");
  });
});

describe("interruptedElsewhere", () => {
  it("lists interrupted cores that are not watched, newest first", () => {
    const cores = [core, { ...core, id: "2" }, { ...running, id: "3" }, { ...core, id: "4" }];
    expect(interruptedElsewhere(cores, "2").map(({ id }) => id)).toEqual(["4", "1"]);
    expect(interruptedElsewhere([core, running], "1")).toEqual([]);
  });
});
