import { describe, expect, it } from "vitest";
import { doingOfCommand } from "../../shared/login/doings";
import type { Command } from "../../shared/run/controls";
import { refusalOfActionByStop, refusalOfCommand } from "../../shared/stop/refusals";

const stopped = { stopped: { by: "alice" } };
const commands = Object.keys(doingOfCommand) as readonly Command[];
const refused = (stop: Parameters<typeof refusalOfCommand>[0]) => commands.filter((command) => refusalOfCommand(stop, command) !== undefined).sort();

describe("while the cell is stopped", () => {
  it("no run begins, goes on or makes a step", () => {
    expect(refused(stopped)).toEqual(["again", "macro", "micro", "resume", "start", "until"]);
    expect(refusalOfCommand(stopped, "start")).toBe("the cell is stopped");
  });
  it("actions that would do so are refused, others are not", () => {
    const action = (id: string, group: string) => refusalOfActionByStop(stopped, { id, group });
    expect([action("live_start", "Page"), action("step_over", "Debug"), action("until_here", "Debug")]).toEqual(Array(3).fill("the cell is stopped"));
    expect([action("rename", "Walk"), action("stop", "Page"), action("search", "Page")]).toEqual(Array(3).fill(undefined));
  });
});

describe("a cell that is free, or of which nothing is known", () => {
  it("refuses nothing", () => expect([...refused({ stopped: null }), ...refused({ stopped: undefined })]).toEqual([]));
});
