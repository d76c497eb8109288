import { describe, expect, it } from "vitest";
import * as schema from "../../generated/validators";
import { check } from "../../shared/messages/check";
import { describeState } from "../../shared/model/describe";
import type { State } from "../../shared/model/model";
import { withOracles } from "../../shared/model/oracles";
import { readModel } from "../../shared/model/readModel";

/** A translated model: Root with this dispatcher in front of A, as the server sends it. */
function translated(dispatcher: object, keep?: object): State {
  const ports = [{ name: "to_A", when: "par.choice == 'A'", to: "A" }];
  const root = { state: "Root", first: "Dispatcher", ...(keep === undefined ? {} : { keep }), children: [{ state: "Dispatcher", ports, ...dispatcher }, { state: "A" }] };
  return readModel(check(schema.native, { document: { rcm: 1, root }, origin: {} }).document).root;
}
const kOrigin = { Root: "Root", "Root/Dispatcher": "Root", "Root/A": "Root/A" };
const choice = (from: string) => ({ parameters: [{ name: "choice", from }] });
const dispatchers = (root: State) => root.children.map((child) => child.kind === "state" && child.dispatcher);

describe("withOracles", () => {
  it("marks what the translation put in front of the children, and nothing else", () => {
    const root = withOracles(translated(choice("par.begin")), kOrigin);
    expect(dispatchers(root)).toEqual(["choice", undefined]);
    expect(root.oracle).toBe("par.begin");
  });
  it("distinguishes history, an expression and a service", () => {
    expect(withOracles(translated(choice("var.last_active")), kOrigin).oracle).toBe("history");
    expect(withOracles(translated({ entry: "svc.display.choose(par.arg0)" }), kOrigin).oracle).toBe("svc.display.choose(par.arg0)");
  });
  it("tells a deep history from one of the children alone", () => {
    const [deep, flat] = [{ deep: true, ports: ["hit"] }, ["hit"]].map((keep) => withOracles(translated(choice("var.last_active"), keep), kOrigin));
    expect([deep?.oracle, flat?.oracle]).toEqual(["deep history", "history"]);
    expect([deep, flat].map((root) => root && dispatchers(root)[0])).toEqual(["deep history", "history"]);
  });
  it("marks what a history remembers, which is not drawn", () => {
    const root = translated(choice("var.last_active"));
    const stores = (name: string) => ({ when: `chi.${name}.active and var.last_active != '${name}'`, do: `var.last_active = '${name}'` });
    const own = { when: "chi.A.active", do: "var.x = 1" };
    const marked = withOracles({ ...root, variables: [{ name: "x" }, { name: "last_active" }], actions: [own, stores("A")] }, kOrigin);
    expect(marked.actions.map(({ made }) => made)).toEqual([undefined, true]);
    expect(describeState(marked).map(({ text }) => text)).toEqual(["x", "[chi.A.active] var.x = 1"]);
  });
  it("leaves a state alone that its author has called Dispatcher", () => {
    const written = withOracles(translated(choice("par.begin")), { ...kOrigin, "Root/Dispatcher": "Root/Dispatcher" });
    expect([dispatchers(written), written.oracle]).toEqual([[undefined, undefined], undefined]);
    expect(withOracles(translated(choice("par.begin")), {})).toEqual(translated(choice("par.begin")));
  });
  it("finds dispatchers of linked states, which come from the library", () => {
    const outer: State = { ...translated({}), name: "Outer", first: "Root", children: [translated(choice("par.at"))] };
    const origin = { Outer: "Outer", "Outer/Root": "Outer/Root", "Outer/Root/Dispatcher": "library/Root", "Outer/Root/A": "library/Root/A" };
    const [inner] = withOracles(outer, origin).children;
    expect(inner?.kind === "state" && inner.oracle).toBe("par.at");
  });
});
