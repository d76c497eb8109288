// Where a document names an element: what the server renames with it.
import { describe, expect, it } from "vitest";
import { usagesOf, usagesOfService } from "../../shared/code/usages";
import type { Tree } from "../../shared/edit/tree";
import { isObject, type JsonValue } from "../../shared/json";
import { treeOf, vector, vectorNames } from "../edit/documents";

const of = (usages: ReturnType<typeof usagesOf>): readonly string[] => [...new Set(usages.map(({ id, field }) => `${id} ${field}`))].sort();
const tree = (root: JsonValue, library: readonly JsonValue[] = []): Tree => treeOf({ rcm: 1, root, library });
const named = (list: string, name: string, more: Readonly<Record<string, JsonValue>> = {}): JsonValue => ({ [list]: name, meta: { id: name.toLowerCase() }, ...more });

/** The fields that the edit of a vector changes, but for the new name itself. */
function changed(edit: JsonValue, id: string): readonly string[] {
  const operations = isObject(edit) && Array.isArray(edit["operations"]) ? (edit["operations"] as readonly { readonly id: string; readonly field: string }[]) : [];
  return [...new Set(operations.map((operation) => `${operation.id} ${operation.field}`))].filter((place) => place !== `${id} state` && place !== `${id} name` && place !== `${id} barrier`).sort();
}

interface RenameVector {
  readonly document: JsonValue;
  readonly compound: { readonly kind: string; readonly id: string };
  readonly edit: JsonValue;
}

it.each(vectorNames("compound.rename"))("%s: what is renamed is what is found", (name) => {
  const { document, compound, edit } = vector(name) as RenameVector;
  expect(of(usagesOf(treeOf(document), compound.id))).toEqual(changed(edit, compound.id));
});

describe("usages", () => {
  it("of a child are targets, the first, an oracle's choices and code", () => {
    const child = named("state", "A", { ports: [named("name", "p", { when: "True", to: "A" })] });
    const root = named("state", "Root", { first: "A", children: [child, named("barrier", "B", { to: ["A"] })], entry: "x = chi.A.active", oracle: { kind: "expr", expr: "'A' if par.x == 'A' else 'C'" } });
    expect(of(usagesOf(tree(root), "a"))).toEqual(["b to", "p to", "root entry", "root first", "root oracle"]);
  });

  it("of a port reach the parent, links, and the state that waits for its time", () => {
    const timed = named("name", "late", { after: "2.0" });
    const library = named("state", "Lib", { ports: [timed], exit: "var.x = chi.After_late.active or port.late", keep: ["late"] });
    const link = named("state", "L", { link: "Lib", ports: [{ name: "late", to: "Z", meta: { id: "own" } }] });
    const root = named("state", "Root", { children: [link], actions: [{ when: "chi.L.port.late", do: "pass", meta: { id: "act" } }] });
    expect(of(usagesOf(tree(root, [library]), "late"))).toEqual(["act when", "lib exit", "lib keep", "own name"]);
    expect(of(usagesOf(tree(root, [library]), "lib"))).toEqual(["l link"]);
  });

  it("of a parameter are in code and where a link gives it a value", () => {
    const inner = { state: "C", meta: { id: "c" }, parameters: [named("name", "q", { from: "par.width" })] };
    const library = named("state", "Lib", { parameters: [named("name", "width")], children: [inner] });
    const root = named("state", "Root", { children: [named("state", "L", { link: "Lib", parameters: [{ name: "width", value: 1, meta: { id: "mine" } }] })] });
    expect(of(usagesOf(tree(root, [library]), "width"))).toEqual(["mine name", "q from"]);
  });

  it("tell where the name stands", () => {
    const root = named("state", "Root", { results: [named("name", "n")], exit: "res.n = 1\nprint(res.n)" });
    expect(usagesOf(tree(root), "n").map(({ span }) => span)).toEqual([{ from: 4, to: 5 }, { from: 20, to: 21 }]);
  });

  it("of a service are its declaration and code", () => {
    const document = treeOf({ rcm: 1, services: { arm: "robot" }, root: named("state", "Root", { entry: "svc.arm.stop()", exit: 'svc["arm"].stop()' }) });
    expect(of(usagesOfService(document, "arm"))).toEqual([" services", "root entry", "root exit"]);
    expect(usagesOfService(document, "leg")).toEqual([]);
  });

  it("of the root are none", () => expect(usagesOf(tree(named("state", "Root")), "root")).toEqual([]));
});
