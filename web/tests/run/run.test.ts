import { describe, expect, it } from "vitest";
import type { Core, CoreDelta, RunState, Values } from "../../generated/messages";
import { buildTree, stateAt } from "../../shared/model/modelTree";
import { applyDelta, runningNow } from "../../shared/run/applyDelta";
import { allowed, goesOnMeanwhile, holdsInputs, primary, setsGoing, statusLook, statusText, until } from "../../shared/run/controls";
import { liveState, type LiveState } from "../../shared/run/liveState";
import { callText, inputText } from "../../shared/run/inputText";
import { atomAdvice, codePieces, constantText, parameterHeadline, readsText, whyHeadline, whySentences } from "../../shared/run/whyText";
import { caseNames, modelOf, runOf } from "../conformance";
import { checkExample } from "../schemas";

const core: Core = { id: "1", document: "pick", revision: 3, status: "running", paused: false, stepping: false, step: 1, micro: 0, waiting: 0, arguments: {}, breakpoints: [], live: false, model: 0 };
const empty: RunState = { active: [], ports: [], activated: {}, parameters: {}, results: {}, variables: {} };

function flags(before: readonly string[], after: readonly string[]): Record<string, boolean> {
  const left = before.filter((entry) => !after.includes(entry)).map((entry) => [entry, false] as const);
  return Object.fromEntries([...left, ...after.filter((entry) => !before.includes(entry)).map((entry) => [entry, true] as const)]);
}

function gone(before: Values, after: Values): Record<string, string[]> {
  const entries = Object.entries(before).map(([path, values]) => [path, Object.keys(values).filter((name) => !(name in (after[path] ?? {})))] as const);
  return Object.fromEntries(entries.filter(([, names]) => names.length > 0).map(([path, names]) => [path, [...names]]));
}

/** The delta that the contract promises between two states. */
function deltaBetween(before: RunState, after: RunState): CoreDelta {
  const emptied = Object.fromEntries(Object.keys(before.activated).map((barrier) => [barrier, []]));
  return {
    core,
    active: flags(before.active, after.active),
    ports: flags(before.ports, after.ports),
    activated: { ...emptied, ...after.activated },
    parameters: after.parameters,
    results: after.results,
    variables: after.variables,
    unset: {
      parameters: gone(before.parameters, after.parameters),
      results: gone(before.results, after.results),
      variables: gone(before.variables, after.variables),
    },
    fired: [],
    calls: [],
  };
}

const plain = (state: LiveState): RunState => ({
  ...state,
  parameters: Object.fromEntries(state.parameters.entries()), results: Object.fromEntries(state.results.entries()), variables: Object.fromEntries(state.variables.entries()),
});
const sorted = (state: RunState) => ({ ...state, active: [...state.active].sort(), ports: [...state.ports].sort() });

describe("applyDelta", () => {
  it.each(caseNames)("follows the recorded run of %s", (name) => {
    let before = empty;
    let state = liveState(empty);
    for (const step of runOf(name).steps) {
      state = applyDelta(state, deltaBetween(before, step.state));
      expect(sorted(plain(state))).toEqual(sorted(step.state));
      before = step.state;
    }
  });
  it("copies no more than what changes: a thousand steps of a large run are cheap", () => {
    const values = Object.fromEntries(Array.from({ length: 1000 }, (_, i) => [`Root/S${i}`, { x: i }]));
    const before = liveState({ ...empty, active: ["Root"], activated: { "Root/Join": ["Root/A.p"] }, parameters: values, results: values });
    const nothing = { core, active: {}, ports: {}, activated: {}, parameters: {}, results: {}, variables: {}, unset: { parameters: {}, results: {}, variables: {} }, fired: [], calls: [] };
    const after = applyDelta(before, { ...nothing, results: { "Root/S7": { y: 1 } } });
    for (const part of ["active", "ports", "activated", "parameters", "variables"] as const) expect(after[part]).toBe(before[part]);
    expect(Object.keys(values).filter((path) => after.results.get(path) !== before.results.get(path))).toEqual(["Root/S7"]);
    expect(after.results.get("Root/S7")).toEqual({ x: 7, y: 1 });
    expect(before.results.get("Root/S7")).toEqual({ x: 7 });
  });
  it("removes a value that is unset, and nothing else", () => {
    const before: RunState = { ...empty, results: { A: { x: 1, y: null } } };
    const after = applyDelta(liveState(before), { ...deltaBetween(before, before), results: {}, unset: { parameters: {}, results: { A: ["x"] }, variables: {} } });
    expect(plain(after).results).toEqual({ A: { y: null } });
  });
});

describe("runningNow", () => {
  it("lists the innermost active states in tree order", () => {
    const tree = buildTree(modelOf("thesis-collision-history").root);
    const state: RunState = { ...empty, active: ["Root/Collision/Display", "Root", "Root/Collision", "Root/Collision/Haptic"] };
    expect(runningNow(state, tree)).toEqual(["Root/Collision/Haptic", "Root/Collision/Display"]);
  });
});

describe("controls", () => {
  it("allow to pause and stop a running core, not to step it", () => {
    expect([...allowed(core)].sort()).toEqual(["pause", "stop"]);
  });
  it("allow to resume, step and stop a paused core", () => {
    expect([...allowed({ ...core, paused: true })].sort()).toEqual(["macro", "micro", "resume", "stop", "until"]);
  });
  it("allow to cancel or replace a step that waits for an input", () => {
    expect([...allowed({ ...core, paused: true, stepping: true })].sort()).toEqual(["macro", "micro", "pause", "resume", "stop", "until"]);
  });
  it("offer nothing but another run when a core is over", () => {
    for (const status of ["ended", "faulted", "aborted"] as const) expect([...allowed({ ...core, status })]).toEqual(["again"]);
  });
  it("hold inputs while a run is paused and something has come for it", () => {
    const held = { ...core, paused: true, waiting: 2 };
    expect([held, { ...held, waiting: 0 }, { ...held, paused: false }, { ...held, status: "interrupted" } as const, { ...held, step: 0 }].map(holdsInputs)).toEqual([true, false, false, false, false]);
  });
  it("give the first button its command", () => {
    expect(primary({ ...core, status: "ready" })).toBe("start");
    expect(primary({ ...core, paused: true })).toBe("resume");
    expect(primary({ ...core, status: "ended" })).toBe("again");
    expect(primary(core)).toBeUndefined();
  });
  it("know which command sets a task going: a step only if it is the first", () => {
    const ready = { status: "ready" } as const;
    const going = (status: Pick<Core, "status">) => (["start", "pause", "resume", "again", "micro", "macro", "until", "stop"] as const).filter((command) => setsGoing(command, status));
    expect(going(ready)).toEqual(["start", "resume", "again", "micro", "macro", "until"]);
    expect(going(core)).toEqual(["start", "resume", "again"]);
  });
  it("name the state that a step goes to by its id, which survives an edit, else by its path", () => {
    const grasp = stateAt(buildTree(modelOf("thesis-pick").root), "Pick/Grasp");
    if (grasp === undefined) throw new Error("the fixture has no Grasp");
    const both = [until(grasp, "Pick/Grasp", "entered"), until({ ...grasp, id: "g" }, "Pick/Grasp", "left")];
    expect(both).toEqual([{ kind: "until", path: "Pick/Grasp", when: "entered" }, { kind: "until", id: "g", when: "left" }]);
    for (const request of both) expect(checkExample("step_request", request)).toBe(request);
  });
  it("refuse a step to a state that is named twice, or not at all", () => {
    for (const names of [{}, { path: "Root", id: "r" }, { id: "Root/A" }])
      expect(() => checkExample("step_request", { kind: "until", when: "left", ...names }), JSON.stringify(names)).toThrow();
  });
  it("give the status of a core", () => {
    expect(statusText({ ...core, status: "ended", outcome: "success" })).toBe("Ended: success");
    expect(statusText({ ...core, paused: true })).toBe("Paused");
    expect(statusText({ ...core, paused: true, stepping: true })).toBe("Paused, its step waits for an input");
    expect(statusText({ ...core, stepping: true })).toBe("Running");
  });
  it("say of a pause that time-outs run on, while it lasts", () => {
    expect(goesOnMeanwhile({ ...core, paused: true })).toMatch(/^Paused: .*the time-outs of open calls run on$/);
    expect([core, { ...core, status: "ready", paused: true } as const, { ...core, status: "ended", paused: true } as const].map(goesOnMeanwhile)).toEqual([undefined, undefined, undefined]);
  });

  it("is told by colours: what is paused waits, and what ended badly has failed", () => {
    expect([statusLook(core), statusLook({ ...core, paused: true }), statusLook({ ...core, status: "aborted", paused: true })]).toEqual(["running", "paused", "aborted"]);
    expect(["success", "error"].map((outcome) => statusLook({ ...core, status: "ended", outcome }))).toEqual(["ended", "failed"]);
  });
});

describe("texts", () => {
  it("distinguish a result from an error", () => {
    expect(inputText({ kind: "response", service: "db", operation: "get", call: 1, result: 3 })).toBe("response db.get → 3");
    expect(inputText({ kind: "response", service: "db", operation: "get", call: 1, error: "no" })).toBe("response db.get ✕ 'no'");
  });
  it("show a call as code", () => {
    expect(callText({ service: "robot", operation: "move", args: [[1, 2]], kwargs: { speed: 0.5 } })).toBe("robot.move([1, 2], speed=0.5)");
  });
  it("give the effect of a change of an atom, and what it reads", () => {
    const atom = { text: "res.w > 1", value: false, service: false, requires: [], reads: [{ text: "res.w", value: 0 }, { text: "par.x" }], blocks: true, wanted: true, together: false };
    const why = { port: "A.p", condition: atom.text, value: false, active: false, state_active: true, reason: "", atoms: [atom] } as const;
    expect(atomAdvice(why, atom)).toBe("becoming true alone would fire this port");
    expect(atomAdvice(why, { ...atom, blocks: false, together: true })).toBe("becoming true would fire it, with the others marked so");
    expect(atomAdvice(why, { ...atom, blocks: false })).toBeUndefined();
    expect(readsText(atom)).toBe("res.w is 0, par.x has no value yet");
  });
  it("say of an action what it waits for", () => {
    const atom = { text: "svc.t.a", value: null, service: true, requires: ["svc.t.a"], reads: [{ text: "svc.t.a" }], blocks: true, wanted: true };
    const why = { state: "R", action: 0, condition: "svc.t.a", value: null, executed: false, state_active: true, reason: "", atoms: [atom] } as const;
    expect(whyHeadline(why)).toBe("Not executed");
    expect(atomAdvice(why, atom)).toBe("becoming true alone would execute this action");
    expect(whyHeadline({ ...why, executed: true })).toBe("Executed in this macro step");
    expect(atomAdvice({ ...why, executed: true }, atom)).toBeUndefined();
    expect(whyHeadline({ ...why, state_active: false })).toBe("Not executed: its state is not active");
    expect(whyHeadline({ ...why, value: true })).toBe("Executed in the next micro step");
    expect(whyHeadline({ ...why, value: true, held: "R3" })).toBe("Not executed: its function reads what is not there yet");
    expect(whyHeadline({ ...why, value: true, held: "R19" })).toBe("Not executed again: it waits for something new");
    expect(whyHeadline({ ...why, value: false, atoms: [{ ...atom, reads: [], requires: [], service: false }] })).toBe("Never executed");
  });
  it("say of a parameter what gives it its value, or would", () => {
    const why = { state: "R/A", parameter: "w", state_active: false, reason: "", reads: [], expression: "var.n" } as const;
    expect(parameterHeadline(why)).toBe("Would have no value");
    expect(parameterHeadline({ ...why, gives: 3 })).toBe("An activation would give it 3");
    expect(parameterHeadline({ ...why, gives: 3, state_active: true, value: 2 })).toBe("The next activation would give it 3");
    expect(parameterHeadline({ ...why, gives: 3, turn: true })).toBe("Its expression gave 3");
    const { expression: _, ...constant } = why;
    expect(parameterHeadline({ ...constant, gives: 3 })).toBe("A constant of the model");
    expect(parameterHeadline({ ...constant, gives: 3, argument: true })).toBe("Given with the start of the run");
  });
  it("give no effect for a port that cannot fire now or has fired, and none for a constant", () => {
    const atom = { text: "res.w", value: false, service: false, requires: [], reads: [{ text: "res.w" }], blocks: true, wanted: true, together: false };
    const why = { port: "A.p", condition: "res.w", value: false, active: false, state_active: true, reason: "", atoms: [atom] } as const;
    expect(atomAdvice(why, atom)).toBeDefined();
    expect(atomAdvice({ ...why, state_active: false }, atom)).toBeUndefined();
    expect(atomAdvice({ ...why, active: true }, atom)).toBeUndefined();
    expect(atomAdvice(why, { ...atom, text: "False", reads: [] })).toBeUndefined();
  });
  describe("texts of a constant condition", () => {
    const atom = { text: "True", value: true, service: false, requires: [], reads: [], blocks: false, together: false };
    const reading = { ...atom, text: "par.x", reads: [{ text: "par.x", value: true }] };
    const why = { port: "A.p", condition: "True", value: true, active: false, state_active: false, reason: "Its state is not active.", atoms: [atom] } as const;
    const never = { ...why, value: false, state_active: true, reason: "It fires when `False` becomes true.", atoms: [{ ...atom, text: "False", value: false, blocks: true }] } as const;
    it("say that it is constant, why, and the consequence", () => {
      expect(constantText(why)).toBe(
        "The condition is constant: it reads no parameter, result, variable, port or service data, so it is always true. Once its state is active, the port needs nothing more to fire.",
      );
      expect(constantText(never)).toMatch(/it reads no .* so it is always false\. The port can never fire\.$/);
      expect(constantText({ ...never, value: null })).toMatch(/its evaluation fails every time\.$/);
      expect(readsText(atom)).toBe("a constant: it reads nothing");
    });
    it("are shown beside the server's reason, unless that names a change", () => {
      expect(whySentences(why)).toEqual([why.reason, constantText(why)]);
      expect(whySentences(never)).toEqual([constantText(never)]);
      expect(whyHeadline(never)).toBe("Never fires");
    });
    it("are not used if one atom of the condition reads something", () => {
      const mixed = { ...why, condition: "True or par.x", atoms: [atom, reading] };
      expect(constantText(mixed)).toBeUndefined();
      expect(whySentences(mixed)).toEqual([why.reason]);
      expect(constantText({ ...why, atoms: [{ ...atom, service: true }] })).toBeUndefined();
      expect(constantText({ ...why, atoms: [] })).toBeUndefined();
    });
  });
  it("distinguish code from words", () => {
    expect(codePieces("It fires when `a` becomes true.")).toEqual([
      { code: false, text: "It fires when " },
      { code: true, text: "a" },
      { code: false, text: " becomes true." },
    ]);
  });
  it("explain a port that is held back", () => {
    const why = { port: "A.p", condition: "svc.s.e", value: true, active: false, state_active: true, reason: "", atoms: [], held: "R9" } as const;
    expect(whyHeadline(why)).toBe("Held back by R9");
    expect(whyHeadline({ ...why, state_active: false })).toBe("Cannot fire: its state is not active");
    expect(whyHeadline({ ...why, active: true })).toBe("This port has fired");
    expect(whyHeadline({ ...why, value: null })).toBe("Does not fire");
  });
});
