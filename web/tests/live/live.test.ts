import { describe, expect, it } from "vitest";
import type { Core } from "../../generated/messages";
import { apply, type Operation } from "../../shared/edit/apply";
import { difference } from "../../shared/edit/difference/difference";
import { differenceRows } from "../../shared/edit/difference/rows";
import { editedModel } from "../../shared/edit/editedModel";
import { Refusal } from "../../shared/edit/refusal";
import type { Tree } from "../../shared/edit/tree";
import { kNoRun, liveOf } from "../../shared/drawing/live";
import { markOf, placeOfRow, rowsByPlace } from "../../shared/live/marks";
import { projectLive } from "../../shared/live/project";
import { allowedBeside, newestRun, runOfDocument, runToTurnTo } from "../../shared/live/shownRun";
import { executesText, parameterText } from "../../shared/live/texts";
import { askableAddress, explainedAt, isActiveNow, valueNow } from "../../shared/live/values";
import { waitingState } from "../../shared/model/afters";
import { buildTree } from "../../shared/model/modelTree";
import { carriedText } from "../../shared/run/edits";
import { treeOf } from "../edit/documents";
import { liveState, type ValueTable } from "../../shared/run/liveState";

const meta = (id: string) => ({ meta: { id } });
const document = treeOf({
  rcm: 1,
  root: {
    state: "Root", ...meta("root"), first: "Both",
    children: [
      { state: "A", ...meta("a"), parameters: [{ name: "speed", value: 0.3, ...meta("speed") }], variables: [{ name: "n", initial: 1, ...meta("n") }], ports: [{ name: "done", when: "True", to: "Join", ...meta("a-done") }, { name: "late", after: "2.5", to: "Join", ...meta("a-late") }] },
      { state: "B", ...meta("b"), results: [{ name: "r", initial: 0, ...meta("r") }], ports: [{ name: "done", when: "True", to: "Join", ...meta("b-done") }] },
      { barrier: "Both", to: ["A", "B"], ...meta("both") },
      { barrier: "Join", to: [], ...meta("join") },
    ],
  },
});

function edited(...operations: readonly Operation[]): Tree {
  const result = apply(document, { operations });
  if (result instanceof Refusal) throw result;
  return result.tree;
}
const entries = (values: ValueTable | undefined) => Object.fromEntries(values?.entries() ?? []);
const modelOf = (tree: Tree) => buildTree(editedModel(tree).root);
const run = liveState({
  active: ["Root", "Root/A", waitingState("Root/A.late")], ports: ["Root/B.done"], activated: { "Root/Join": ["Root/B.done"] },
  parameters: { "Root/A": { speed: 0.3 } }, results: { "Root/B": { r: 7 } }, variables: { "Root/A": { n: 4 } },
});
const live = liveOf(run, { fireCount: 3, ports: ["Root/B.done"] }, { fault: { kind: "type", at: "Root/A", message: "" }, badEnd: "Root/B.done" });
const of = modelOf(document);

describe("a run on the drawing of an edited document", () => {
  it("is itself where nothing was edited", () => {
    expect(projectLive(live, of, modelOf(document))).toEqual(live);
    expect(projectLive(kNoRun, of, of)).toBe(kNoRun);
  });

  it("follows what was renamed, moved and given other names, by ids", () => {
    const onto = modelOf(edited(
      { op: "insert", parent: "root", list: "children", node: { state: "Group", ...meta("group") } },
      { op: "move", id: "a", parent: "group", list: "children" },
      { op: "set", id: "a", field: "state", value: "Approach" },
      { op: "set", id: "n", field: "name", value: "count" },
      { op: "set", id: "b-done", field: "name", value: "ready" },
      { op: "set", id: "join", field: "barrier", value: "Meet" },
    ));
    const shown = projectLive(live, of, onto);
    expect([...shown.active]).toEqual(["Root", "Root/Group/Approach", waitingState("Root/Group/Approach.late")]);
    expect([...shown.fired]).toEqual(["Root/B.ready"]);
    expect(shown.activated).toEqual({ "Root/Meet": ["Root/B.ready"] });
    expect(entries(shown.run?.variables)).toEqual({ "Root/Group/Approach": { count: 4 } });
    expect(entries(shown.run?.parameters)).toEqual({ "Root/Group/Approach": { speed: 0.3 } });
    expect([shown.faultAt, shown.badEnd]).toEqual(["Root/Group/Approach", "Root/B.ready"]);
  });

  it("does not fall to what has come in the place of something else", () => {
    const onto = modelOf(edited({ op: "remove", id: "a" }, { op: "insert", parent: "root", list: "children", node: { state: "A", ...meta("other"), variables: [{ name: "n", ...meta("other-n") }] } }));
    const shown = projectLive(live, of, onto);
    expect([...shown.active]).toEqual(["Root"]);
    expect([entries(shown.run?.variables), shown.faultAt]).toEqual([{}, undefined]);
  });
});

describe("the value of an element in the run", () => {
  it("is found by its id", () => {
    expect(["speed", "n", "r", "a-done", "nobody"].map((id) => valueNow(of, run, id))).toEqual([0.3, 4, 7, undefined, undefined]);
    expect(["a", "a-done", "speed", "b", "nobody"].map((id) => isActiveNow(of, run, id))).toEqual([true, true, true, false, false]);
  });
  it("is asked for of ports whose state is active alone", () => {
    expect([askableAddress(of, run, "a-done"), askableAddress(of, run, "b-done"), askableAddress(of, run, "a")]).toEqual(["Root/A.done", undefined, undefined]);
  });
  it("is explained on the page of the run, of ports, parameters and actions", () => {
    expect(explainedAt(of, "b-done")).toEqual({ selection: { kind: "port", address: "Root/B.done" }, asked: undefined });
    expect(explainedAt(of, "speed")).toEqual({ selection: { kind: "node", path: "Root/A" }, asked: { parameter: "speed" } });
    const acting = buildTree(editedModel(treeOf({ rcm: 1, root: { state: "R", ...meta("r"), actions: [{ when: "True", do: "pass", ...meta("one") }, { when: "True", do: "pass", ...meta("two") }] } })).root);
    expect(explainedAt(acting, "two")).toEqual({ selection: { kind: "node", path: "R" }, asked: { action: 1 } });
    expect([explainedAt(of, "n"), explainedAt(of, "a"), explainedAt(of, "nobody")]).toEqual([undefined, undefined, undefined]);
  });
});

const core: Core = { id: "3", document: "pick", revision: 12, status: "running", paused: false, stepping: false, step: 7, micro: 0, waiting: 0, arguments: {}, breakpoints: [], live: true, model: 0 };

describe("the run that is shown", () => {
  it("is of the document that is edited, or none", () => {
    expect(runOfDocument(core, "pick")).toBe(core);
    expect([runOfDocument(core, "place"), runOfDocument(core, undefined), runOfDocument(undefined, "pick"), runOfDocument(undefined, undefined)]).toEqual([undefined, undefined, undefined, undefined]);
  });
  it("is turned to when a document is opened, unless another one is under way", () => {
    const [old, now, other] = [{ ...core, id: "1", status: "ended" } as const, { ...core, id: "2" }, { ...core, id: "9", document: "place" }];
    expect(newestRun([now, old, other], "pick")).toBe(now);
    expect(newestRun([old, other], "pick")).toBe(old);
    expect(newestRun([other], "pick")).toBeUndefined();
    expect(runToTurnTo([old, now, other], undefined, "pick")).toBe(now);
    expect(runToTurnTo([old, now, other], { ...other, status: "ended" }, "pick")).toBe(now);
    expect(runToTurnTo([old, now, other], old, "pick"), "the user has chosen it").toBeUndefined();
    for (const status of ["running", "interrupted"] as const) expect(runToTurnTo([old, now, other], { ...other, status }, "pick"), status).toBeUndefined();
  });
  it("is moved from the page that edits its document, and only stopped from one that edits another", () => {
    expect([...allowedBeside({ ...core, paused: true }, "pick")].sort()).toEqual(["macro", "micro", "resume", "stop", "until"]);
    expect([...allowedBeside({ ...core, paused: true }, "place")]).toEqual(["stop"]);
    expect([...allowedBeside(core, "place")]).toEqual(["pause", "stop"]);
    expect([...allowedBeside({ ...core, status: "ready" }, "place")]).toEqual([]);
    expect([...allowedBeside({ ...core, status: "ready" }, undefined)]).toContain("start");
  });
});

describe("what the page says", () => {
  it("of what runs and what is edited", () => {
    expect(executesText(core, 15)).toBe("Run 3 executes revision 12; you edit revision 15");
    expect(executesText({ ...core, revision: 15 }, 15)).toBe("Run 3 executes revision 15, which you edit");
    expect(executesText({ ...core, status: "ended" }, 15)).toBe("Run 3 is over; it executed revision 12; you edit revision 15");
  });
  it("of an edit that was carried", () => {
    expect(carriedText(core, { ...core, revision: 15, model: 240 })).toBe("Run 3 executes revision 15 since step 240");
    expect(carriedText({ ...core, status: "ready" }, { ...core, status: "ready", revision: 15 })).toBe("Run 3 executes revision 15 from its beginning");
    expect(carriedText(core, { ...core, revision: 15 }), "layout alone").toBeUndefined();
    expect(carriedText(core, { ...core, id: "4", revision: 15, model: 240 }), "another run").toBeUndefined();
    expect(carriedText(core, { ...core, step: 8 })).toBeUndefined();
  });
  it("beside a parameter", () => {
    const parameter = { now: 0.3, constant: 0.5, isArgument: false, isExecuted: true, isActive: true, core };
    expect(parameterText(parameter)).toBe("used from the next activation on; now: 0.3");
    expect(parameterText({ ...parameter, isActive: false })).toBe("used from the next activation on; last: 0.3");
    expect(parameterText({ ...parameter, constant: 0.3 })).toBe("now: 0.3");
    expect(parameterText({ ...parameter, constant: undefined })).toBe("now: 0.3");
    expect(parameterText({ ...parameter, isExecuted: false })).toBe("not in the run yet; now: 0.3");
    expect(parameterText({ ...parameter, isExecuted: false, core: { live: false } })).toBe("not in the run, which does not follow edits; now: 0.3");
    expect(parameterText({ ...parameter, isArgument: true })).toBe("used by the next run; now: 0.3");
    expect(parameterText({ ...parameter, now: undefined })).toBeUndefined();
  });
});

describe("a row of the difference", () => {
  const after = edited(
    { op: "remove", id: "b" },
    { op: "set", id: "n", field: "initial", value: 2 },
    { op: "insert", parent: "root", list: "children", node: { state: "New", ...meta("new") } },
    { op: "set", id: "", field: "services", key: "arm", value: "panda" },
  );
  const rows = differenceRows(document, after, difference(document, after));
  const row = (id: string) => rows.find((each) => each.id === id) ?? rows[0] ?? { kind: "added", id, name: "", text: "" };

  it("leads to its element, or to what was around it", () => {
    expect(["new", "n", "b", ""].map((id) => placeOfRow(document, after, row(id)))).toEqual(["new", "n", "root", undefined]);
  });
  it("is marked at what is drawn of it", () => {
    const marks = (isShown: (id: string) => boolean) => [...rowsByPlace(document, after, rows, isShown)].map(([id, all]) => `${id} ${markOf(id, all).sign}`);
    expect(marks(() => true)).toEqual(["new +", "root −", "a ≠"]);
    expect(marks((id) => id === "root"), "of a closed state").toEqual(["root ≠"]);
    expect(markOf("a", [row("n")]).text).toBe("changed: variable n of Root/A: initial: 1 → 2");
  });
});
