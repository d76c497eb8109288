// In which round a loop is, and how long rounds took.
import { describe, expect, it } from "vitest";
import type { JsonValue } from "../../shared/json";
import { buildTree, type ModelTree } from "../../shared/model/modelTree";
import { readModel } from "../../shared/model/readModel";
import { Table } from "../../shared/run/table";
import { addSkill, addTask } from "../../shared/timeline/changes/add";
import { loopSteps } from "../../shared/timeline/changes/loop";
import { readApplication } from "../../shared/timeline/read";
import { roundsIn, timed, type RoundTimes } from "../../shared/timeline/rounds";
import { allSteps, type Step } from "../../shared/timeline/timeLine";
import { emptyApp, skills, stateNamed } from "../skills/fixture";
import { after, supplies } from "./after";

function looped(times: number): { readonly loop: Step; readonly model: ModelTree; readonly counter: string; readonly count: string } {
  const made = after(emptyApp, addTask(emptyApp, "root", 0, "My task", supplies));
  const say = after(made.tree, addSkill(made.tree, made.id, 0, { document: "skills", id: stateNamed(skills.tree, "Say") }, supplies));
  const { tree } = after(say.tree, loopSteps(say.tree, [say.id], times, supplies));
  const loop = allSteps(readApplication(tree).root).find(({ kind }) => kind === "loop");
  if (loop?.counter === undefined) throw new Error("there is no loop");
  // The model of a run has the same ids.
  const model = buildTree(readModel({ rcm: 1, root: { state: "Root", first: "Count", meta: { id: "root" }, children: [{ state: "Count", meta: { id: loop.counter } }] } }).root);
  return { loop, model, counter: loop.counter, count: "Root/Count" };
}

const known = (results: Readonly<Record<string, Readonly<Record<string, JsonValue>>>>, parameters: typeof results = {}) => ({ results: Table.of(Object.entries(results)), parameters: Table.of(Object.entries(parameters)) });

describe("the round of a loop", () => {
  const { loop, model, counter, count } = looped(5);

  it("is the one after those that are counted", () => {
    expect(roundsIn([loop], model, known({}), new Set())).toMatchObject([{ number: 1, of: 5 }]);
    expect(roundsIn([loop], model, known({ [count]: { done: 2 } }), new Set())).toMatchObject([{ number: 3, of: 5 }]);
  });

  it("is not over while it is counted", () => {
    expect(roundsIn([loop], model, known({ [count]: { done: 5 } }), new Set([counter]))).toMatchObject([{ number: 5, of: 5 }]);
  });

  it("is one of as many as the run has been told", () => {
    expect(roundsIn([loop], model, known({}, { [count]: { times: 7 } }), new Set())).toMatchObject([{ of: 7 }]);
  });

  it("is one of no number if the loop goes on for ever", () => {
    const endless = looped(0);
    expect(roundsIn([endless.loop], endless.model, known({ [endless.count]: { done: 2 } }), new Set())).toMatchObject([{ number: 3, of: undefined }]);
  });

  it("is there for loops alone", () => {
    expect(roundsIn(loop.inner?.steps ?? [], model, known({}), new Set())).toEqual([]);
  });
});

describe("the time of a round", () => {
  type Look = readonly [now: number, done: number, isActive?: boolean, isHeld?: boolean];
  const look = (...looks: readonly Look[]): RoundTimes | undefined => looks.reduce<RoundTimes | undefined>((before, [now, done, isActive = true, isHeld = false]) => timed(before, { now, done, isActive, isHeld }), undefined);

  it("is that from one count to the next, also of the last round, with which the loop is left", () => {
    expect(look([0, 0, false], [100, 0], [300, 1], [700, 2])).toMatchObject({ last: 400, sum: 600, count: 2 });
    expect(look([0, 0, false], [100, 0], [300, 1, false])).toMatchObject({ last: 200, count: 1, began: undefined });
  });

  it("is not known of the round in which the page came", () => {
    expect(look([0, 3], [300, 4])).toMatchObject({ last: undefined, count: 0, began: 300 });
  });

  it("is not told of a round in which the run was held", () => {
    expect(look([0, 0, false], [100, 0], [200, 0, true, true], [300, 0], [900, 1], [1000, 2])).toMatchObject({ last: 100, count: 1 });
  });

  it("of rounds that passed unseen between two looks is what each took of it", () => {
    expect(look([0, 0, false], [100, 0], [400, 3])).toMatchObject({ last: 100, sum: 300, count: 3 });
  });

  it("goes on from a loop that was entered again, and the same look changes nothing", () => {
    const twice = look([0, 0, false], [100, 0], [300, 1, false], [500, 0], [900, 1]);
    expect(twice).toMatchObject({ last: 400, sum: 600, count: 2 });
    expect(timed(twice, { now: 950, done: 1, isActive: true, isHeld: false })).toBe(twice);
  });
});
