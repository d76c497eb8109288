import { describe, expect, it } from "vitest";
import type { Run } from "../../generated/messages";
import { kNoPlaces } from "../../shared/drawing/places";
import { buildTree } from "../../shared/model/modelTree";
import { readModel } from "../../shared/model/readModel";
import { allowed } from "../../shared/run/controls";
import { coreOfRun } from "../../shared/runs/storedRun";
import { durationText, outcomeText, runTime, storedText, underWay } from "../../shared/runs/texts";
import { applyEvent, commandable, emptySession, isStored, watchedCore } from "../../shared/session/session";
import { checkExample } from "../schemas";
import { readJson } from "../files";

const run = readJson(new URL("../../../api/examples/run.ended.json", import.meta.url)) as Run;

describe("a stored run", () => {
  const model = readModel({ rcm: 1, root: { state: "Root" } });
  const core = coreOfRun(run);
  const connected = applyEvent(emptySession, { type: "connection", connection: "open" });
  const shown = applyEvent(connected, { type: "stored", run: { core, model, places: kNoPlaces, state: undefined, steps: [] } });
  it("is shown as the core that hosted it, which is of the schema of cores", () => {
    expect(checkExample("core", core)).toMatchObject({ id: "1", status: "ended", outcome: "done", results: { n: 1 }, step: 2 });
    expect(watchedCore(shown)).toBe(core);
    expect([isStored(shown), shown.document, [...buildTree(shown.model?.root ?? model.root).keys()]]).toEqual([true, "ticking", ["Root"]]);
  });
  it("can be run again, once it is over", () => {
    expect([...allowed(commandable(shown))]).toEqual(["again"]);
    const open = coreOfRun({ ...run, status: "interrupted" });
    const left = applyEvent(connected, { type: "stored", run: { core: open, model, places: kNoPlaces, state: undefined, steps: [] } });
    expect(commandable(left)).toBeUndefined();
  });
  it("is not it any more when a core hosts it, or another run is watched", () => {
    expect(isStored(applyEvent(shown, { type: "update", update: { type: "cores", cores: [core] } }))).toBe(false);
    expect(watchedCore(applyEvent(shown, { type: "watched", id: "9" }))).toBeUndefined();
  });
  it("says what it came to, and how long it took", () => {
    expect([outcomeText(run), runTime(run)]).toEqual(["Ended: done", "0.0 s"]);
    expect(runTime({ ...run, ended: run.created + 90_500 })).toBe("1 min 31 s");
    expect([0.04, 9.94, 10, 59.4, 60, 3600, 90_061].map((seconds) => durationText(seconds * 1000))).toEqual(["0.0 s", "9.9 s", "10 s", "59 s", "1 min", "1 h", "1 d 1 h"]);
    expect(underWay({ created: 1000, ended: 13_400 }, { steps: [{ step: 1, time: 2_400_000 }] })).toBe("10 s");
    expect(underWay({ created: 1000, ended: 13_400 }, { steps: [] })).toBe("12 s");
    expect(underWay({ created: 1000 }, { steps: [] })).toBeUndefined();
    expect(storedText(core).title).toContain("is stored");
  });
});
