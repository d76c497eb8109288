import { describe, expect, it } from "vitest";
import { doingOfCommand } from "../../shared/login/doings";
import type { Command } from "../../shared/run/controls";
import { refusalOfActionByStop, refusalOfCommand, refusalOfDoing, refusalToBegin, refusalToMove } from "../../shared/stop/refusals";

const free = { stopped: null, mode: "execution", holder: null, held: undefined } as const;
const stopped = { ...free, stopped: { by: "alice" } };
const taken = { ...free, holder: { number: 4, by: "bob" } };
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
  it("refuses nothing", () => expect([...refused(free), ...refused({ ...free, stopped: undefined, mode: undefined })]).toEqual([]));
});

describe("while somebody has the controls", () => {
  it("nobody else begins anything; who has them does, as soon as they know", () => {
    expect(refused(taken)).toEqual(["again", "macro", "micro", "resume", "start", "until"]);
    expect([refusalToBegin(taken), refusalToBegin({ ...taken, held: 3 })], "they were taken by another one since").toEqual(Array(2).fill("bob has the controls"));
    expect([refused({ ...taken, held: 4 }), refused({ ...free, held: 5 }), refused({ ...taken, held: 5 })]).toEqual([[], [], []]);
  });
  it("nobody else forces a value, or puts the cell back", () => {
    for (const doing of ["force", "reset_cell"] as const)
      expect([refusalOfDoing(free, doing), refusalOfDoing(stopped, doing), refusalOfDoing(taken, doing), refusalOfDoing({ ...taken, held: 4 }, doing)]).toEqual([undefined, "the cell is stopped", "bob has the controls", undefined]);
  });
  it("they alone set the mode and confirm edits", () => {
    for (const doing of ["set_mode", "confirm_edit"] as const)
      expect([refusalOfDoing(free, doing), refusalOfDoing(taken, doing), refusalOfDoing({ ...taken, held: 4 }, doing)]).toEqual(["take the controls first", "bob has the controls", undefined]);
  });
});

describe("in programming mode", () => {
  const programming = { ...free, mode: "programming" } as const;
  it("nothing begins without the controls", () => {
    expect([refusalToBegin(programming), refusalToBegin({ ...programming, held: 1 })]).toEqual(["in programming mode, take the controls first", undefined]);
    expect([refusalOfDoing(programming, "force"), refusalOfDoing(programming, "reset_cell")]).toEqual(["in programming mode, take the controls first", undefined]);
  });
  it("alone, who has the controls moves the cell by hand, unless it is stopped", () => {
    expect(refusalToMove({ ...programming, held: 1 })).toBeUndefined();
    expect([refusalToMove(free), refusalToMove({ ...free, held: 1 }), refusalToMove({ ...programming, ...stopped, held: 1 })]).toEqual(["take the controls first", "this needs programming mode", "the cell is stopped"]);
  });
});
