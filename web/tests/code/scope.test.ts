// What may be written in a text of a document, what is known of a name, and which names mean nothing.
import { describe, expect, it } from "vitest";
import { completionAt } from "../../shared/code/completion";
import { hoverAt } from "../../shared/code/hover";
import { mistakesIn } from "../../shared/code/mistakes";
import { conditionScope, scopeOf, type CodePlace } from "../../shared/code/scope";
import type { KnownService } from "../../shared/code/services";
import type { JsonValue } from "../../shared/json";
import { statesOf, textsInScope } from "../../shared/code/texts";
import { treeOf } from "../edit/documents";
import { readJson } from "../files";

const gripper: KnownService = {
  key: "gripper",
  type: "wsg50",
  rsm: {
    rsm: 1, name: "wsg50",
    operations: [
      { name: "grasp", doc: "Closes until the fingers meet an object.", result: { record: { actual_width: "number" } }, parameters: [{ name: "width", type: "number", unit: "m", min: 0, max: 0.11, doc: "Opening of the fingers" }, { name: "force", type: "number", unit: "N", value: 40 }] },
      { name: "stop", safe: true },
    ],
    events: [{ name: "state", data: { record: { width: "number", held: "bool" } }, rate_hz: 50 }],
  },
};

const el = (id: string, fields: Readonly<Record<string, JsonValue>>): JsonValue => ({ ...fields, meta: { id } });
const library = [el("lib", { state: "Grasp", parameters: [el("w", { name: "width", type: "number", unit: "m", doc: "Of the object" }), el("v", { name: "v", from: "par.nothing" })], results: [el("held", { name: "held" })], ports: [el("done", { name: "done", when: "True" })] })];
const pick = el("pick", { state: "Pick", link: "Grasp", parameters: [el("pw", { name: "width", from: "par.size" })] });
const root = el("root", {
  state: "Root",
  parameters: [el("size", { name: "size", type: "number", unit: "m" }), el("where", { name: "where", type: "pose" })],
  results: [el("found", { name: "found", type: { list: "pose" } })],
  exit: "var.count = 1",
  actions: [el("act", { when: "True", do: "pass" })],
  children: [pick, el("gate", { barrier: "Gate", to: [] })],
  ports: [el("out", { name: "out", when: "False" }), el("late", { name: "late", after: "1.0" })],
});
const tree = treeOf({ rcm: 1, services: { hand: "wsg50", eye: "camera" }, root, library });
const scope = (id: string, field: CodePlace["field"]) => scopeOf(tree, { id, field }, [gripper]);
const entry = scope("root", "entry");
const condition = scope("act", "when");
const from = scope("pw", "from");

/** The items where `|` stands, as they would be inserted. */
function offered(text: string, of = entry): readonly string[] {
  const position = text.indexOf("|");
  return completionAt(text.replace("|", ""), position, of)?.items.map(({ insert }) => insert) ?? [];
}

describe("the condition of a breakpoint", () => {
  const wrong = (id: string | undefined, text: string) => mistakesIn(text, conditionScope(tree, id, [gripper])).map(({ message }) => message);
  it("uses the names of its state: of a port and an action the one that has it, of the whole task the root", () => {
    for (const id of ["root", "act", "out", undefined]) expect([wrong(id, "par.size > 1 and port.out"), wrong(id, "par.width > 1")]).toEqual([[], ["width is not declared here"]]);
    expect(wrong("lib", "par.width > 1")).toEqual([]);
  });
  it("may name anything of a state that is not known, but nothing that no state has", () => {
    for (const [id, of] of [["gone", tree], ["root", undefined]] as const) expect([mistakesIn("par.x and svc.y.z.result", conditionScope(of, id, [])), mistakesIn("parr.x", conditionScope(of, id, []))[0]?.message]).toEqual([[], "parr is not known here"]);
  });
});

describe("completion", () => {
  it("offers what is declared", () => {
    expect(offered("x = par.|")).toEqual(["size", "where"]);
    expect(offered("res.fo|")).toEqual(["found"]);
    expect(offered("var.|")).toEqual(["count"]);
    expect(offered("port.|", condition)).toEqual(["out", "late"]);
  });

  it("offers what a child has, by its library state", () => {
    expect(offered("chi.|")).toEqual(["Pick", "Gate", "After_late", "After"]);
    expect(offered("chi.Pick.|")).toEqual(["par", "res", "port", "active", "name"]);
    expect(offered("chi.Pick.par.|")).toEqual(["width", "v"]);
    expect(offered("chi.Gate.|")).toEqual(["active", "name"]);
  });

  it("offers services, their operations and events; functions call them, conditions read what they answered", () => {
    expect(offered("svc.|")).toEqual(["gripper", "hand", "eye"]);
    expect(offered("svc.hand.|")).toEqual(["grasp()", "stop()", "state"]);
    expect(offered("svc.gripper.|", condition)).toEqual(["grasp", "stop", "state"]);
    expect(offered("svc.gripper.grasp.|", condition)).toEqual(["result", "error"]);
    expect(offered("svc.gripper.grasp.result.|", condition)).toEqual(["actual_width", ...offered("par.where.|").slice(2)]);
    expect(offered("svc.gripper.state.|", condition)).toEqual(expect.arrayContaining(["latest", "width", "held"]));
  });

  it("offers the arguments of a call, and does not repeat brackets", () => {
    expect(offered("svc.gripper.grasp(|").slice(0, 2)).toEqual(["width=", "force="]);
    expect(offered("svc.gripper.grasp(0.1, fo|)").slice(0, 2)).toEqual(["width=", "force="]);
    expect(offered("svc.gripper.gr|(1)")).toContain("grasp");
  });

  it("puts the cursor between the brackets of what has parameters", () => {
    const items = completionAt("svc.gripper.", 12, entry)?.items ?? [];
    expect(items.map(({ insert, cursor }) => insert.slice(0, cursor))).toEqual(["grasp(", "stop()", "state"]);
  });

  it("offers fields of records and poses, methods of lists, functions of modules, locals and keywords", () => {
    expect(offered("par.where.|").slice(0, 2)).toEqual(["position", "orientation"]);
    expect(offered("res.found.|")).toEqual(expect.arrayContaining(["append()", "count()"]));
    expect(offered("geo.dis|")).toContain("distance()");
    expect(offered("speed = 1\nfor pose in res.found:\n    |")).toEqual(expect.arrayContaining(["speed", "pose", "while", "svc", "available()"]));
    expect(offered("|", condition)).not.toContain("while");
  });

  it("sees no services and ports in an expression, and its parent's names in a `from`", () => {
    expect(offered("par.|", from)).toEqual(["size", "where"]);
    expect(offered("|", from)).not.toContain("svc");
    expect(offered("|", scope("late", "after"))).not.toContain("port");
    expect(offered("svc.|", from)).toEqual([]);
  });

  it("says nothing in comments, texts and numbers, but in what is formatted", () => {
    expect(completionAt("# par.", 6, entry)).toBeUndefined();
    expect(completionAt("'par.'", 5, entry)).toBeUndefined();
    expect(completionAt("1.", 2, entry)).toBeUndefined();
    expect(offered("f'{par.|}'")).toEqual(["size", "where"]);
  });

  it("is shown unasked when something has been begun", () => {
    expect(completionAt("", 0, entry)?.isBegun).toBe(false);
    expect(completionAt("a", 1, entry)?.isBegun).toBe(true);
    expect(completionAt("par.", 4, entry)?.isBegun).toBe(true);
  });
});

describe("hover", () => {
  const lines = (text: string, word: string, of = entry) => hoverAt(text, text.indexOf(word) + 1, of)?.lines;
  it("says what a value is, with its unit", () => {
    expect(lines("x = par.size", "size")).toEqual(["par.size: number [m]"]);
    expect(lines("chi.Pick.par.width", "width")).toEqual(["chi.Pick.par.width: number [m]", "Of the object"]);
  });

  it("says what an operation takes and answers", () => {
    expect(lines("svc.gripper.grasp(0.1)", "grasp")).toEqual([
      "svc.gripper.grasp(width, [force])", "Closes until the fingers meet an object.", "width: number [m], from 0 to 0.11. Opening of the fingers", "force: number [N]", "result: {actual_width: number}",
    ]);
    expect(lines("svc.gripper.grasp(width=0.1)", "width")).toEqual(["width: number [m], from 0 to 0.11. Opening of the fingers"]);
    expect(lines("svc.gripper.stop()", "stop")).toEqual(["svc.gripper.stop()", "result: none", "Safe: it is called when a run faults."]);
  });

  it("says what a function does, and nothing of what is not known", () => {
    expect(lines("geo.distance(a, b)", "distance")?.[0]).toBe("geo.distance(a, b)");
    expect(lines("speed = 1", "speed")).toEqual(["speed: of this text alone"]);
    expect(lines("nobody", "nobody")).toBeUndefined();
    expect(lines("'par'", "par")).toBeUndefined();
  });
});

describe("mistakes", () => {
  const mistakes = (text: string, of = entry) => mistakesIn(text, of).map(({ from: start, to, message, severity }) => `${text.slice(start, to)}: ${message}${severity === "warning" ? " (warning)" : ""}`);
  it("are names that are not declared", () => {
    expect(mistakes("x = par.siz + chi.Nobody.res.y\nres.found = chi.Pick.res.helt")).toEqual(["siz: siz is not declared here", "Nobody: there is no child Nobody", "helt: helt is not declared here"]);
    expect(mistakes("chi.Gate.par.x", condition)).toEqual(["par: chi.Gate has no par"]);
    expect(mistakes("nobody + geo.far(1)", condition)).toEqual(["nobody: nobody is not known here", "far: geo has no far"]);
    expect(mistakes("f'{par.siz}'", condition)).toEqual(["siz: siz is not declared here"]);
  });

  it("are services where none are seen", () => expect(mistakes("svc.gripper.state", from)).toEqual(["svc: svc is not visible in an expression"]));

  it("are no errors, if services are not there", () => {
    expect(mistakes("svc.eye.look()\nsvc.nose.smell()\nsvc.gripper.graps()")).toEqual(["nose: there is no service nose now (warning)", "graps: svc.gripper has no graps (warning)"]);
    expect(mistakesIn("svc.nose.smell()", scopeOf(tree, { id: "root", field: "entry" }, []))).toEqual([]);
  });

  it("are not in what is right", () => {
    expect(mistakes("var.new = [p.x for p in res.found if p.x > par.size]\na, b = 1, 2\nif a == b and available(res.found):\n    svc.gripper.grasp(width=a, force=b) # nobody\n    print(sep='nobody')")).toEqual([]);
    expect(mistakes("par.anything + var.x", scope("v", "from"))).toEqual([]);
    expect(mistakes("chi.After_late.par.seconds", condition)).toEqual([]);
  });
});

it.each(["pick", "demonstrator", "skills"])("nothing is found wrong with the texts of the demo's %s", (name) => {
  const demo = treeOf(readJson(new URL(`../../../deploy/demo/${name}.rcm.json`, import.meta.url)) as JsonValue);
  const texts = statesOf(demo).flatMap((state) => textsInScope(demo, state));
  expect(texts.length).toBeGreaterThan(5);
  expect(texts.flatMap(({ id, field, text }) => mistakesIn(text, scopeOf(demo, { id, field }, [])).map((mistake) => ({ text, mistake })))).toEqual([]);
});
