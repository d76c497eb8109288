import { describe, expect, it } from "vitest";
import { editedState } from "../../shared/edit/editedModel";
import { fuzzyFilter } from "../../shared/edit/fuzzy";
import { walk, type Way } from "../../shared/edit/walk";
import { buildTree } from "../../shared/model/modelTree";
import { document } from "./commands/fixture";

const model = buildTree(editedState(document, "root"));
const node = (path: string) => ({ kind: "node", path }) as const;
const port = (address: string) => ({ kind: "port", address }) as const;

describe("arrow keys", () => {
  it.each([
    [node("Root/B"), "next", node("Root/C")],
    [node("Root/B"), "previous", node("Root/A")],
    [node("Root/A"), "previous", node("Root/A")],
    [node("Root/C"), "in", node("Root/C/D")],
    [node("Root/A"), "in", port("Root/A.done")],
    [node("Root/C/D"), "out", node("Root/C")],
    [node("Root/C/D"), "ports", port("Root/C/D.done")],
    [port("Root/A.done"), "out", node("Root/A")],
    [node("Root"), "out", undefined],
    [undefined, "next", node("Root/A")],
  ] as const)("lead from %j %s to %j", (from, way: Way, to) => expect(walk(model, from, "Root", way)).toEqual(to));
});

describe("commands by some letters", () => {
  const names = ["Add state", "Add barrier", "Undo", "Ungroup", "Duplicate"];
  const found = (query: string) => fuzzyFilter(query, names, (name) => name);
  it("are those that have them in this order, the best first", () => {
    expect(found("as")[0]).toBe("Add state");
    expect(found("ung")).toEqual(["Ungroup"]);
    expect(found("xq")).toEqual([]);
    expect(found("")).toEqual(names);
  });
});
