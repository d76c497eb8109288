// Operations that no service can accept, as completion has them: what is asked for a text of a document, and how the answer is shown.
import { describe, expect, it } from "vitest";
import { spotOf, taskOf } from "../../shared/code/assistance";
import { completionAt, marked, offersOperations } from "../../shared/code/completion";
import { scopeOf, type CodePlace } from "../../shared/code/scope";
import { unreachableOperations } from "../../shared/orchestration/unreachable";
import type { JsonValue } from "../../shared/json";
import { treeOf } from "../edit/documents";
import { kLamp } from "../orchestration/models";

const el = (id: string, fields: Readonly<Record<string, JsonValue>>): JsonValue => ({ ...fields, meta: { id } });
const document = {
  rcm: 1, services: { light: "lamp" },
  library: [el("lib", { state: "Blink", children: [el("inner", { state: "On", entry: "" })] })],
  root: el("root", { state: "Root", first: "A", children: [el("a", { state: "A", entry: "svc.light.light()", actions: [el("act", { when: "True", do: "" })] }), el("a2", { state: "A" }), el("gate", { barrier: "G", to: [] })] }),
};
const lamp = { ...kLamp, type: "lamp" };
const tree = treeOf(document);
const task = taskOf(tree, [lamp], undefined);

/** What is offered where `|` stands, each operation with why it is not accepted. */
function offered(place: CodePlace, text: string) {
  const position = text.indexOf("|");
  const found = completionAt(text.replace("|", ""), position, scopeOf(tree, place, [lamp]));
  const spot = found && spotOf(tree, task, place, text.slice(0, found.from));
  if (found === undefined || spot === undefined) return undefined;
  return marked(found, unreachableOperations(task.document, task.services, spot.path, spot.place)).items.map(({ name, against }) => (against === undefined ? name.name : `${name.name}: ${against}`));
}

describe("the completion of operations", () => {
  const kOff = "light can only be in `off` here; dim is accepted in `on`";
  const kDouse = "light can only be in `off` here; douse is accepted in `on`";
  it("marks those that no state of the service accepts, last and with the reason", () => {
    expect(offered({ id: "a", field: "entry" }, "svc.light.|")).toEqual(["light", `dim: ${kOff}`, `douse: ${kDouse}`]);
    const found = completionAt("svc.light.", 10, scopeOf(tree, { id: "a", field: "entry" }, [lamp]));
    expect(found && marked(found, new Map([["svc.light.light", "why"]])).items.map(({ name }) => name.name)).toEqual(["dim", "douse", "light"]);
  });
  it("counts the calls before it, and those of the entry for an action", () => {
    expect(offered({ id: "a", field: "entry" }, "svc.light.light()\nsvc.light.|")).toEqual(["light", "dim", "douse"]);
    expect(offered({ id: "act", field: "do" }, "svc.light.|")).toEqual(["light", "dim", "douse"]);
  });
  it("is asked for only where operations are offered", () => {
    const at = (text: string) => completionAt(text, text.length, scopeOf(tree, { id: "a", field: "entry" }, [lamp]));
    expect([at("svc.light."), at("svc."), at("pa")].map((found) => found && offersOperations(found))).toEqual([true, false, false]);
  });
});

describe("the place of a text in the task that is analysed", () => {
  it("is the path of its state, by which siblings of one name differ; in the library too", () => {
    expect(spotOf(tree, task, { id: "a2", field: "exit" }, "x")).toEqual({ path: "Root/A#2", place: { code: "exit", before: "x" } });
    expect(spotOf(tree, task, { id: "inner", field: "entry" }, "")).toEqual({ path: "Blink/On", place: { code: "entry", before: "" } });
    expect(spotOf(tree, task, { id: "act", field: "do" }, "x")).toEqual({ path: "Root/A", place: { code: "action" } });
  });
  it("is none, of a text that calls nothing", () => {
    expect(spotOf(tree, task, { id: "act", field: "when" }, "")).toBeUndefined();
  });
  it("is in the same task until states or services change", () => {
    expect(taskOf(treeOf(document), [lamp], task)).not.toBe(task);
    expect(taskOf({ ...tree, fields: { ...tree.fields, layout: {} } }, [lamp], task)).toBe(task);
    expect(taskOf(tree, [], task)).not.toBe(task);
  });
});
