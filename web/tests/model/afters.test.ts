// What translation makes of `after` (core/SEMANTICS.md, section 6) is a part of the port again.
import { describe, expect, it } from "vitest";
import * as schema from "../../generated/validators";
import { check } from "../../shared/messages/check";
import { timedElement, waitingState, withAfters } from "../../shared/model/afters";
import { portText } from "../../shared/model/describe";
import type { State } from "../../shared/model/model";
import { buildTree, portAt } from "../../shared/model/modelTree";
import { withOracles } from "../../shared/model/oracles";
import { readModel } from "../../shared/model/readModel";
import { search } from "../../shared/model/search";
import { runningNow } from "../../shared/run/applyDelta";
import { selectionAt } from "../../shared/session/view";

interface NativeState {
  readonly state: string;
  readonly first?: string;
  readonly children?: readonly object[];
  readonly ports?: readonly object[];
}

const stateOf = (root: object, origin: Readonly<Record<string, string>>): State => readModel(check(schema.native, { document: { rcm: 1, root }, origin }).document).root;

/** As the server sends what `after: seconds` of the port was translated to. */
const waiting = (port: string, from: string) => ({
  state: `After_${port}`,
  parameters: [{ name: "seconds", from, unit: "s" }],
  variables: [{ name: "tries", initial: 1 }],
  entry: "svc.timer.wait(par.seconds)",
  actions: [
    { when: "svc.timer.wait.error.code == 'unavailable' and var.tries < 10", do: "var.tries += 1\nsvc.timer.wait(par.seconds)" },
    { when: "svc.timer.wait.error.code != 'unavailable'", do: "int('time-out: ' + svc.timer.wait.error.code)" },
  ],
  ports: [{ name: "due", when: "svc.timer.wait.result" }],
});
const exit = (port: string, to?: string) => ({ name: port, when: `chi.After_${port}.port.due`, ...(to !== undefined && { to }) });
const done = { name: "done", when: "svc.S.op.result" };
const kOrigin = { Root: "Root", "Root.late": "Root.late", "Root/After_late": "Root.late", "Root/After_late.due": "Root.late" };
const kBoth = { ...kOrigin, "Root/After": "Root" };

function folded(root: NativeState, origin: Readonly<Record<string, string>>): State {
  return withAfters(stateOf(root, origin), origin);
}

describe("withAfters", () => {
  it("makes of the state that waits the time-out of the port, and of its state a leaf again", () => {
    const native = { state: "Root", first: "After_late", children: [waiting("late", "par.timeout")], ports: [done, exit("late")] };
    expect(folded(native, kOrigin)).toEqual(stateOf({ state: "Root", ports: [done, { name: "late", after: "par.timeout" }] }, {}));
  });
  it("makes of several ports several time-outs, without the barrier", () => {
    const barrier = { barrier: "After", to: ["After_late", "After_soon"] };
    const native = { state: "Root", first: "After", children: [waiting("late", "9"), waiting("soon", "1"), barrier], ports: [exit("late"), exit("soon")] };
    const origin = { ...kBoth, "Root/After_soon": "Root.soon" };
    expect(folded(native, origin)).toEqual(stateOf({ state: "Root", ports: [{ name: "late", after: "9" }, { name: "soon", after: "1" }] }, {}));
  });
  it("lets the state begin where it did, with a state or a barrier", () => {
    const fork = { barrier: "Fork", to: ["A", "B"] };
    const other = { barrier: "Other", to: ["B", "A"] };
    const written = [{ state: "A" }, { state: "B" }, other, fork];
    const begin = (first: string, children: readonly object[], to: readonly string[]) => {
      const made = [...children, waiting("late", "2"), { barrier: "After", to: [...to, "After_late"] }];
      const root = folded({ state: "Root", first: "After", children: made, ports: [exit("late")] }, kBoth);
      expect(root).toEqual(stateOf({ state: "Root", first, children, ports: [{ name: "late", after: "2" }] }, {}));
    };
    begin("B", written, ["B"]);
    begin("Fork", written, ["A", "B"]);
    begin("Other", written, ["B", "A"]);
  });
  it("takes a barrier that leads to one state for the first if nothing else leads to it", () => {
    const gate = { barrier: "Gate", to: ["A"] };
    const first = (a: object) => folded({ state: "Root", first: "After", children: [a, gate, waiting("late", "2"), { barrier: "After", to: ["A", "After_late"] }], ports: [exit("late")] }, kBoth).first;
    expect(first({ state: "A" })).toBe("Gate");
    expect(first({ state: "A", ports: [{ ...done, to: "Gate" }] })).toBe("A");
  });
  it("leaves the oracle of the state to be found", () => {
    const dispatcher = { state: "Dispatcher", parameters: [{ name: "choice", from: "par.begin" }], ports: [{ name: "to_A", when: "par.choice == 'A'", to: "A" }] };
    const made = [dispatcher, { state: "A" }, waiting("late", "2"), { barrier: "After", to: ["Dispatcher", "After_late"] }];
    const origin = { ...kBoth, "Root/Dispatcher": "Root", "Root/A": "Root/A" };
    const root = withOracles(folded({ state: "Root", first: "After", children: made, ports: [exit("late")] }, origin), origin);
    expect([root.first, root.oracle, root.children.map(({ name }) => name)]).toEqual(["Dispatcher", "par.begin", ["Dispatcher", "A"]]);
  });
  it("folds in linked states, whose ports come from the library", () => {
    const inner = { state: "Move", first: "After", children: [{ state: "Go" }, waiting("late", "par.timeout"), { barrier: "After", to: ["Go", "After_late"] }], ports: [exit("late", "Next")] };
    const origin = { Root: "Root", "Root/Move": "Root/Move", "Root/Move.late": "Root/Move.late", "Root/Move/Go": "library/M/Go", "Root/Move/After_late": "library/M.late", "Root/Move/After": "library/M" };
    const [move] = folded({ state: "Root", children: [inner, { state: "Next" }] }, origin).children;
    expect(move).toEqual(stateOf({ state: "Move", first: "Go", children: [{ state: "Go" }], ports: [{ name: "late", after: "par.timeout", to: "Next" }] }, {}));
  });
  it("leaves alone what its author has called so, and a model without origins", () => {
    const native = { state: "Root", first: "After", children: [waiting("late", "2"), { barrier: "After", to: ["After_late"] }], ports: [exit("late")] };
    for (const origin of [{}, { Root: "Root", "Root/After_late": "Root/After_late", "Root/After": "Root/After" }]) expect(folded(native, origin)).toEqual(stateOf(native, {}));
    // A barrier of the author beside a state that was made, which needs none.
    const { first, children } = folded({ ...native, first: "After_late" }, { ...kOrigin, "Root/After": "Root/After" });
    expect([first, children.map(({ name }) => name)]).toEqual([undefined, ["After"]]);
  });
  it("keeps the ids of ports", () => {
    const native = { state: "Root", first: "After_late", children: [waiting("late", "2")], ports: [{ ...exit("late"), meta: { id: "p" } }] };
    expect(folded(native, kOrigin).ports).toEqual([{ id: "p", name: "late", after: "2" }]);
  });
});

describe("a run of a model with time-outs", () => {
  it("is in the state that has the time-out, not in what waits for it", () => {
    const native = { state: "Root", first: "A", children: [{ state: "A", first: "After_late", children: [waiting("late", "2")], ports: [exit("late")] }] };
    const tree = buildTree(folded(native, { Root: "Root", "Root/A": "Root/A", "Root/A/After_late": "Root/A.late" }));
    const nothing = { ports: [], activated: {}, parameters: {}, results: {}, variables: {} };
    expect(runningNow({ ...nothing, active: ["Root", "Root/A", "Root/A/After_late"] }, tree)).toEqual(["Root/A"]);
  });
});

describe("a port with a time-out", () => {
  const root = stateOf({ state: "Root", first: "A", children: [{ state: "A", ports: [{ name: "late", after: "par.timeout + 1" }, { name: "soon", after: "2.5" }, done] }] }, {});
  const tree = buildTree(root);
  it("says how long after the activation of its state it fires", () => {
    const texts = ["late", "soon", "done"].map((name) => portAt(tree, `Root/A.${name}`)).map((port) => port && portText(port));
    expect(texts).toEqual(["after (par.timeout + 1) s", "after 2.5 s", "svc.S.op.result"]);
  });
  it("is found by the expression of its time-out, and with all others by `after`", () => {
    expect(search(tree, "PAR.timeout")).toEqual([{ kind: "port", target: "Root/A.late", context: "after (par.timeout + 1) s" }]);
    expect(search(tree, "after").map(({ target }) => target)).toEqual(["Root/A.late", "Root/A.soon"]);
  });
  it("is selected for what was made of it, and its state for the barrier", () => {
    expect(waitingState("Root/A.late")).toBe("Root/A/After_late");
    for (const made of ["Root/A/After_late", "Root/A/After_late.due"]) expect(selectionAt(tree, made)).toEqual({ kind: "port", address: "Root/A.late" });
    expect(selectionAt(tree, "Root/A/After")).toEqual({ kind: "node", path: "Root/A" });
    for (const none of ["Root/After", "Root/A/After_done", "Root/A/After_late.other", "Root/A/After_late/B", "After"]) expect(timedElement(tree, none), none).toBeUndefined();
  });
  it("has no condition besides, and one of both", () => {
    const ports = (...all: readonly object[]) => () => stateOf({ state: "Root", ports: all }, {});
    expect(ports({ name: "p" })).toThrow("/p/when");
    expect(ports({ name: "p", when: "True", after: "2" })).toThrow("/p/after");
  });
});
