import { describe, expect, it } from "vitest";
import type { Core, Past, RunState, TraceStep } from "../../generated/messages";
import { badEndShown, stateShown, faultShown, firedShown, stepsShown, stepsUntil } from "../../shared/past/shown";
import { pastStatus, pastText, placeText } from "../../shared/past/texts";
import { applyEvent, emptySession, type Session, type SessionEvent } from "../../shared/session/session";
import { modelOf, runOf } from "../conformance";

const core: Core = { id: "7", document: "pick", revision: 3, status: "faulted", paused: false, stepping: false, step: 57, micro: 0, waiting: 0, arguments: {}, breakpoints: [], live: false, model: 0, fault: { kind: "unmet", at: "Root", message: "" } };
const steps = runOf("thesis-pick").steps.slice(0, 3).map(({ micro, calls }, i): TraceStep => ({ step: i + 1, input: { kind: "start" }, micro, calls }));
const state = (active: string): RunState => ({ active: [active], ports: [], activated: {}, parameters: {}, results: {}, variables: {} });
const past: Past = { step: 2, micro: 1, complete: false, status: "running", state: state("Root/Then"), events: [], open_calls: [], digest: "0".repeat(64) };

const present: readonly SessionEvent[] = [
  { type: "update", update: { type: "cores", cores: [core] } },
  { type: "watched", id: "7" },
  { type: "update", update: { type: "state", id: "7", state: { core, state: state("Root/Now") } } },
  { type: "update", update: { type: "derivations", id: "7", steps } },
];
const now = present.reduce((session, event) => applyEvent(session, event), emptySession);
const looking = (shown: Partial<Past> = {}): Session => applyEvent(now, { type: "moment", id: "7", shown: { past: { ...past, ...shown }, steps: [], model: undefined, doubt: undefined } });

describe("what is shown of a run", () => {
  it("is the present, until the page looks at a moment of the past; the present is still there", () => {
    expect([stateShown(now)?.active, faultShown(now)?.kind]).toEqual([["Root/Now"], "unmet"]);
    expect([stateShown(looking())?.active, faultShown(looking())]).toEqual([["Root/Then"], undefined]);
    expect(looking().run?.active).toEqual(["Root/Now"]);
    expect(firedShown({ ...looking(), fired: { fireCount: 1, ports: ["Root.p"], open: undefined, frame: undefined } }).ports).toEqual([]);
  });
  it("has the port of the root through which it ended badly, as it was at the moment", () => {
    const { root } = modelOf("thesis-pick");
    const model = { name: "pick", services: {}, library: [], root };
    const ended = (outcome: string): Session => ({ ...now, model, cores: [{ ...core, status: "ended", outcome }] });
    expect([badEndShown(ended("error")), badEndShown(ended("done"))]).toEqual([`${root.name}.error`, undefined]);
    expect(badEndShown({ ...looking({ status: "ended", outcome: "error" }), model })).toBe(`${root.name}.error`);
    expect(badEndShown({ ...looking(), model, cores: [{ ...core, status: "ended", outcome: "error" }] })).toBeUndefined();
  });
  it("is the present again when it turns from there, or to another run", () => {
    expect(stateShown(applyEvent(looking(), { type: "moment", id: "7", shown: undefined }))?.active).toEqual(["Root/Now"]);
    expect(applyEvent(looking(), { type: "watched", id: "8" }).past).toBeUndefined();
    expect(applyEvent(looking(), { type: "moment", id: "8", shown: undefined })).toEqual(looking());
  });
  it("has only the derivations of what had been done then", () => {
    expect(stepsUntil(now)).toBe(now.steps);
    const until = stepsUntil(looking());
    expect(until.map(({ step, micro }) => [step, micro.length])).toEqual([[1, steps[0]?.micro.length], [2, 1]]);
    const same = looking();
    expect(stepsUntil(same)).toBe(stepsUntil(same));
  });
  it("lists the derivations around the moment, if it is older than the others", () => {
    const old = applyEvent(now, { type: "moment", id: "7", shown: { past: { ...past, step: 40 }, steps: steps.slice(1), model: undefined, doubt: undefined } });
    expect(stepsShown(old)).toEqual(steps.slice(1));
    expect(stepsShown(looking())).toBe(now.steps);
  });
});

describe("the banner", () => {
  it("says which moment it is, and that robots do not move back", () => {
    expect(pastText({ ...past, step: 12, micro: 3 }, { ...core, status: "running" }, false)).toEqual({ title: "You look at step 12.3.", holds: "The run is at 57. Robots do not move back." });
    expect(pastText(past, { ...core, status: "running", micro: 2 }, false).holds).toContain("The run is at 57.2.");
    expect(pastText(past, { ...core, status: "ended" }, false).holds).toBe("The run is over, at 57. Robots do not move back.");
    expect(pastText(past, core, true).holds).toBe("The run has 57 steps and is over.");
  });
  it("says between which micro steps it is", () => {
    const texts = [past, { ...past, micro: 0 }, { ...past, complete: true }, { ...past, micro: 0, complete: true }].map(placeText);
    expect(texts).toEqual(["In macro step 2, after 1 micro step.", "In macro step 2, before its first micro step.", "At the end of macro step 2, after 1 micro step.", "Nothing changes in macro step 2."]);
  });
  it("has the status that the run had", () => {
    expect([pastStatus(past), pastStatus({ ...past, status: "ended", outcome: "done" }), pastStatus({ ...past, status: "faulted", fault: { kind: "unmet", at: "", message: "" } })]).toEqual(["Running", "Ended: done", "Faulted: unmet"]);
  });
});
