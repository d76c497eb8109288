import { describe, expect, it } from "vitest";
import { facts, inferenceOf, judgement, lastInference, leading, microNumber, microStepText, nodeAt, notable, rowParts, size, subjectText, summary } from "../../shared/derivation/proof";
import type { Derivation, TraceStep } from "../../generated/messages";
import { momentText } from "../../shared/past/moment";
import { caseNames, runOf } from "../conformance";

const all = (node: Derivation): readonly Derivation[] => [node, ...node.premises.flatMap(all)];
const collision = runOf("thesis-collision-history").steps;
const node = (rule: string): Derivation => {
  const found = collision.flatMap((step) => step.micro.flatMap(all)).find((entry) => entry.rule === rule);
  if (found === undefined) throw new Error(`no ${rule}`);
  return found;
};

const step = (number: number, first: number, micro: readonly Derivation[]): TraceStep => ({
  step: number, input: { kind: "start" }, micro, calls: [], first, complete: true,
});

describe("judgement", () => {
  it.each(caseNames)("has a conclusion for every node of %s, and none is empty", (name) => {
    for (const entry of runOf(name).steps.flatMap((s) => s.micro.flatMap(all))) expect(judgement(entry)).not.toBe("");
  });
  it("uses the symbols of the thesis", () => {
    expect(judgement(node("PTrans1"))).toBe("Σ,Δ ⊢ Pick → Pick′, Δ′");
    expect(judgement(node("SDeact2"))).toBe("Σ,Δ ⊢ Dispatcher →↓ Dispatcher′, Δ′");
    expect(judgement(node("Active"))).toBe("Δ ⊢ Root.active ⇝ False");
    expect(judgement(node("FuncSC"))).toBe("gripper.release() is called");
  });
});

describe("lastInference", () => {
  const fires = (port: string): Derivation => ({
    rule: "Micro", equation: "3.31", at: "R", premises: [{ rule: "PTrigger", equation: "3.27", at: "R/A", port, premises: [] }],
  });
  it("finds the latest micro step in which the port fired, also in a part of a macro step", () => {
    const steps = [step(1, 0, [fires("p")]), step(2, 0, [fires("q"), fires("p"), fires("q")]), step(3, 2, [fires("q")])];
    expect(lastInference(steps, { port: "R/A.p" })).toEqual({ step: 2, micro: 1 });
    expect(lastInference(steps, { port: "R/A.q" })).toEqual({ step: 3, micro: 2 });
  });
  it("is undefined for a port that did not fire", () => {
    expect(lastInference([step(1, 0, [fires("p")])], { port: "R/B.p" })).toBeUndefined();
    expect(lastInference([], { port: "R/A.p" })).toBeUndefined();
  });
});

describe("the inference of an action or a parameter", () => {
  const executes: Derivation = { rule: "Action1", equation: "4.17", at: "R/A", action: 1, premises: [] };
  const resolves: Derivation = { rule: "Resolve", equation: "3.13", at: "R/B", parameter: "w", value: 6, premises: [] };
  const steps = [step(1, 0, [executes, resolves]), step(2, 0, [{ ...executes, rule: "Action3" }])];
  it("is the last execution, not one that did not come", () => {
    expect(lastInference(steps, { state: "R/A", action: 1 })).toEqual({ step: 1, micro: 0 });
    expect(lastInference(steps, { state: "R/A", action: 0 })).toBeUndefined();
  });
  it("is that by which the parameter got its value", () => {
    expect(lastInference(steps, { state: "R/B", parameter: "w" })).toEqual({ step: 1, micro: 1 });
    expect(lastInference(steps, { state: "R/A", parameter: "w" })).toBeUndefined();
  });
});

describe("a micro step", () => {
  it("is counted from 1, as by moments and by race derive", () => {
    expect(microStepText({ step: 3, micro: 0 })).toBe("macro step 3, micro step 1");
    expect(momentText({ step: 3, micro: microNumber(0) })).toBe("3.1");
  });
});

describe("inferenceOf", () => {
  it("leads to the inference by which the port fired, among others", () => {
    const fires = (at: string, port: string): Derivation => ({ rule: "PTrigger", equation: "3.27", at, port, premises: [] });
    const root: Derivation = { rule: "Micro", equation: "3.31", at: "R", premises: [fires("R/A", "p"), { rule: "SProp", equation: "3.30", at: "R", premises: [fires("R/B", "q"), fires("R/B", "p")] }] };
    expect(inferenceOf(root, { port: "R/B.p" })).toEqual([1, 1]);
    expect(inferenceOf(root, { port: "R/A.p" })).toEqual([0]);
    expect(inferenceOf(root, { port: "R/C.p" })).toBeUndefined();
  });
});

describe("subjectText", () => {
  it("keeps the node that a port of another leads to apart from that port", () => {
    const entered: Derivation = { rule: "SAct1", equation: "3.22", at: "Root/B", port: "Root/A.success", premises: [] };
    expect(subjectText(entered)).toBe("B by Root/A.success");
  });
  it("names ports, parameters and actions of a node", () => {
    expect(subjectText(node("Resolve"))).toBe("Pick.par.pose");
    expect(subjectText(node("PTrigger"))).toBe("Dispatcher.to_Release");
    expect(subjectText(node("Action1"))).toMatch(/\.actions\[\d\]$/);
  });
});

describe("rowParts", () => {
  const row = (entry: Derivation) => rowParts(entry).map((part) => part.text).join(" ");
  const full = (entry: Derivation) => rowParts(entry).map((part) => part.full ?? part.text).join(" ");
  it("says the value, what was read and the refinement of a condition", () => {
    const cond: Derivation = {
      rule: "Cond", equation: "4.12", at: "Root/Pick", action: 0, value: null, requires: ["db.get.result", "db.get.error"], refinement: "R2", premises: [],
    };
    expect(row(cond)).toBe("Cond (4.12) Pick.actions[0] None reads db.get.result, db.get.error R2");
    expect(full(cond)).toBe("Cond (4.12) Root/Pick.actions[0] None reads db.get.result, db.get.error R2");
  });
  it("says a call with all its arguments", () => {
    const call: Derivation = {
      rule: "FuncSC", equation: "4.14", at: "Root/Move", service: "robot", operation: "move", args: [{ offset: [0, 0, 0.1500001] }], kwargs: { kind: "lin", speed: 0.25 }, premises: [],
    };
    expect(row(call)).toBe("FuncSC (4.14) Move robot.move({'offset': [0, 0, 0.1500001]}, kind='lin', speed=0.25)");
  });
  it("cuts nothing", () => {
    const long = "x".repeat(500);
    expect(row({ rule: "Resolve", equation: "3.13", at: "A", parameter: "p", value: long, premises: [] })).toContain(`'${long}'`);
  });
  it.each(caseNames)("tells every two nodes of %s apart that differ in more than their premises", (name) => {
    const read = new Map<string, string>();
    for (const entry of runOf(name).steps.flatMap((s) => s.micro.flatMap(all))) {
      const own = JSON.stringify({ ...entry, premises: [] });
      expect(read.get(full(entry)) ?? own, full(entry)).toBe(own);
      read.set(full(entry), own);
    }
  });
});

describe("facts", () => {
  it.each(caseNames)("tells every two nodes of %s apart that differ in more than their rule and premises", (name) => {
    const read = new Map<string, string>();
    for (const { rule, equation, premises, ...held } of runOf(name).steps.flatMap((s) => s.micro.flatMap(all))) {
      const text = JSON.stringify(facts({ rule, equation, premises, ...held }));
      const own = JSON.stringify({ ...held, kwargs: Object.keys(held.kwargs ?? {}).length === 0 ? undefined : held.kwargs });
      expect(read.get(text) ?? own, text).toBe(own);
      read.set(text, own);
    }
  });
});

describe("a proof tree", () => {
  const micro = collision[3]?.micro[0];
  if (micro === undefined) throw new Error("the recorded run is too short");
  it("counts its nodes as they are", () => {
    for (const root of collision.flatMap((s) => s.micro)) expect(size(root)).toBe(all(root).length);
  });
  it("unfolds notable inferences and folds the others", () => {
    expect(notable(micro)).toBe(true);
    expect(notable(node("Cond"))).toBe(false);
    const idle: Derivation = { rule: "SProp", equation: "3.30", at: "Root", premises: [{ rule: "Active", equation: "3.8", at: "Root", premises: [], value: true }] };
    expect(notable(idle)).toBe(false);
  });
  it("summarizes a micro step", () => {
    expect(summary(micro)).toBe("Pick.collision fires");
  });
  it("leads to the first inference at which something happens", () => {
    expect(nodeAt(micro, leading(micro))).toMatchObject({ rule: "PTrigger", at: "Root/Pick", port: "collision" });
    expect(leading(node("PTrans1"))).toEqual([]);
  });
  it("finds a node by its path", () => {
    expect(nodeAt(micro, [0, 1])).toBe(micro.premises[0]?.premises[1]);
    expect(nodeAt(micro, [9])).toBeUndefined();
  });
  it("keeps a null value apart from none", () => {
    const cond: Derivation = { rule: "Cond", equation: "4.12", at: "A", premises: [], value: null };
    expect(facts(cond)).toContainEqual({ name: "value", text: "None" });
  });
});
