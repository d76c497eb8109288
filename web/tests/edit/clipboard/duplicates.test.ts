import { describe, expect, it } from "vitest";
import { duplicates } from "../../../shared/edit/clipboard/duplicates";
import { readExact, writeExact } from "../../../shared/edit/exact";
import { documentOf, listOf } from "../../../shared/edit/tree";
import { after, childrenOf, document, field, newIds } from "../commands/fixture";

const kExact = readExact(JSON.stringify({ ...documentOf(document), layout: { d: { x: 1, y: 2 }, c: { x: 3, y: 4 } } }).replace('"x":1,', '"x":1.0,'));
const made = (...ids: string[]) => duplicates(kExact, document, ids, newIds());

describe("copies of several elements", () => {
  it("are one edit, stand behind the last of their siblings, and lead to each other", () => {
    const command = made("b", "a");
    const tree = after(command);
    expect(childrenOf(tree, "root")).toEqual(["A", "B", "A2", "B2", "C", "Both", "L"]);
    const [a2 = "", b2 = ""] = listOf(tree, "root", "children").slice(2);
    expect(field(tree, listOf(tree, a2, "ports")[0] ?? "", "to")).toBe("B2");
    expect("made" in command && [...command.made].sort()).toEqual([a2, b2].sort());
  });
  it("may be in several states, and have what is inside where it was", () => {
    const command = made("c", "both");
    const tree = after(command);
    expect(childrenOf(tree, "root")).toEqual(["A", "B", "C", "Both", "C2", "Both2", "L"]);
    const [d2 = ""] = listOf(tree, listOf(tree, "root", "children")[4] ?? "", "children");
    expect("change" in command && command.change.operations.filter(({ op }) => op === "set").map((operation) => writeExact(operation as never))).toEqual([`{"op":"set","id":"","field":"layout","key":"${d2}","value":{"x":1.0,"y":2}}`]);
    expect(childrenOf(after(made("d", "a")), "c")).toEqual(["D", "D2", "E"]);
  });
  it("are of states and barriers", () => {
    expect(made("root")).toHaveProperty("reason");
    expect(made("gone")).toHaveProperty("reason");
  });
});
