// What the name under the cursor stands for, and where it is used, in words.
import { describe, expect, it } from "vitest";
import { referentAt, usagesOfReferent, type Referent } from "../../shared/code/referent";
import type { CodePlace } from "../../shared/code/scope";
import { referentName, referentText, usageLine } from "../../shared/code/usageLines";
import type { JsonValue } from "../../shared/json";
import { treeOf } from "../edit/documents";

const el = (id: string, fields: Readonly<Record<string, JsonValue>>): JsonValue => ({ ...fields, meta: { id } });
const tree = treeOf({
  rcm: 1, services: { hand: "wsg50" },
  library: [el("lib", { state: "Grasp", entry: "svc.hand.grasp(par.width)", parameters: [el("w", { name: "width" })], ports: [el("done", { name: "done", when: "True" })] })],
  root: el("root", {
    state: "Root", first: "Pick", parameters: [el("size", { name: "size" })], variables: [el("n", { name: "n" })],
    actions: [el("act", { when: "chi.Pick.port.done", do: "x = 1\nvar.count = par.size\nsvc.hand.stop()" })],
    children: [el("pick", { state: "Pick", link: "Grasp", parameters: [el("pw", { name: "width", from: "par.size" })] }), el("gate", { barrier: "Gate", to: ["Pick"] })],
  }),
});

/** What the name at `|` stands for. */
function at(text: string, place: CodePlace = { id: "root", field: "entry" }): Referent | undefined {
  return referentAt(tree, place, text.replace("|", ""), text.indexOf("|"));
}
const element = (id: string): Referent => ({ kind: "element", id });

describe("the name under the cursor", () => {
  it("is an element of its state", () => {
    expect(at("x = par.si|ze + 1")).toEqual(element("size"));
    expect(at("var.|n = 1")).toEqual(element("n"));
    expect(at("par.size|", { id: "pw", field: "from" })).toEqual(element("size"));
    expect(at("par.wid|th", { id: "lib", field: "entry" })).toEqual(element("w"));
  });
  it("is a child, or what its library state has", () => {
    expect(at("chi.Pi|ck.par.width")).toEqual(element("pick"));
    expect(at("chi.Pick.par.wid|th")).toEqual(element("w"));
    expect(at("chi.Pick.port.done|", { id: "act", field: "when" })).toEqual(element("done"));
  });
  it("is a variable without declaration, a service, or an operation", () => {
    expect(at("var.cou|nt = 2")).toEqual({ kind: "variable", state: "root", name: "count" });
    expect(at("svc.ha|nd.stop()")).toEqual({ kind: "service", key: "hand" });
    expect(at("svc.hand.st|op()")).toEqual({ kind: "service", key: "hand", member: "stop" });
  });
  it("is none elsewhere", () => {
    for (const text of ["p|ar.size", "par.nothi|ng", "x| = 1", "# par.si|ze", "chi.Nobody.par.wid|th"]) expect(at(text), text).toBeUndefined();
  });
});

describe("usages in words", () => {
  const lines = (referent: Referent) => usagesOfReferent(tree, referent).map((usage) => usageLine(tree, usage, referentName(tree, referent))).map(({ place, before, name, after }) => `${place}: ${before}[${name}]${after}`);
  it("are the lines of code, with where they are", () => {
    expect(lines(element("size"))).toEqual(["Root, action 1, function: var.count = par.[size]", "Root/Pick, parameter width, expression: par.[size]"]);
    expect(lines({ kind: "variable", state: "root", name: "count" })).toEqual(["Root, action 1, function: var.[count] = par.size"]);
  });
  it("are targets and links, in the library too", () => {
    expect(lines(element("pick"))).toEqual(["Root/Gate, target: [Pick]", "Root, first: [Pick]", "Root, action 1, condition: chi.[Pick].port.done"]);
    expect(lines(element("lib"))).toEqual(["Root/Pick, link: [Grasp]"]);
    expect(lines(element("w"))).toEqual(["library/Grasp, entry: svc.hand.grasp(par.[width])", "Root/Pick, parameter width, redefined: [width]"]);
  });
  it("are calls of a service, and its declaration", () => {
    expect(lines({ kind: "service", key: "hand" })).toEqual(["the document, services: [hand]", "Root, action 1, function: svc.[hand].stop()", "library/Grasp, entry: svc.[hand].grasp(par.width)"]);
    expect(lines({ kind: "service", key: "hand", member: "stop" })).toEqual(["Root, action 1, function: svc.hand.[stop]()"]);
  });
  it("are of something that has a name", () => {
    const all: readonly Referent[] = [element("pick"), element("done"), element("lib"), { kind: "variable", state: "root", name: "count" }, { kind: "service", key: "hand", member: "stop" }];
    expect(all.map((each) => referentText(tree, each))).toEqual(["state Root/Pick", "port done of library/Grasp", "state library/Grasp", "variable count of Root", "stop of the service hand"]);
  });
});
