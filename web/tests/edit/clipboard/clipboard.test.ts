import { describe, expect, it } from "vitest";
import { copyText } from "../../../shared/edit/clipboard/copy";
import { paste } from "../../../shared/edit/clipboard/paste";
import { readExact, writeExact } from "../../../shared/edit/exact";
import { documentOf, listOf, writeNode } from "../../../shared/edit/tree";
import { after, childrenOf, document, field, newIds, reasonOf } from "../commands/fixture";

const kExact = readExact(JSON.stringify(documentOf(document)).replace('"doc":0', '"doc":1.0'));
const copied = (...ids: string[]): string => {
  const copy = copyText(kExact, document, ids);
  return "text" in copy ? copy.text : copy.reason;
};

describe("copying", () => {
  it("gives the elements in their order, with all in them", () => {
    expect(JSON.parse(copied("c", "a"))).toMatchObject({ children: [{ state: "A" }, { state: "C", children: [{ state: "D" }, { state: "E" }] }] });
    expect(JSON.parse(copied("a-done"))).toMatchObject({ ports: [{ name: "done", to: "B" }] });
  });
  it("keeps numbers as they were written", () => {
    const exact = readExact('{"root": {"state": "Root", "meta": {"id": "root"}, "children": [{"state": "A", "meta": {"id": "a", "weight": 1.0, "big": 12345678901234567890}}]}}');
    const copy = copyText(exact, document, ["a"]);
    expect("text" in copy && copy.text).toContain('"weight": 1.0');
    expect("text" in copy && copy.text).toContain("12345678901234567890");
  });
  it("needs a selection that is stored", () => {
    expect(copied()).toBe("nothing is selected");
    expect(copyText(readExact('{"root": {}}'), document, ["a"])).toEqual({ reason: "the server does not have it yet" });
  });
});

describe("pasting", () => {
  it("gives new ids and free names, and keeps what leads from one to another", () => {
    const tree = after(paste(document, "l", copied("a", "b", "both"), newIds()));
    expect(childrenOf(tree, "root")).toEqual(["A", "B", "C", "Both", "L", "A2", "B2", "Both2"]);
    const [a2 = "", b2 = "", both2 = ""] = listOf(tree, "root", "children").slice(5);
    expect([a2, b2, both2].every((id) => /^n\d+$/.test(id))).toBe(true);
    expect(field(tree, listOf(tree, a2, "ports")[0] ?? "", "to")).toBe("B2");
    expect(field(tree, listOf(tree, b2, "ports")[0] ?? "", "to")).toBe("Both2");
    expect(field(tree, both2, "to")).toEqual(["C", "A2"]);
  });
  it("renames siblings in what takes their values, not in texts", () => {
    const text = '{"children": [{"state": "A"}, {"state": "N", "parameters": [{"name": "p", "from": "chi.A.res.x + \'chi.A\'"}]}]}';
    const tree = after(paste(document, "root", text, newIds()));
    const added = listOf(tree, "root", "children").at(-1) ?? "";
    expect(writeNode(tree, added)).toMatchObject({ parameters: [{ from: "chi.A2.res.x + 'chi.A'" }] });
  });
  it("goes into the selected composite, which may begin there, or ports to the selected state", () => {
    expect(childrenOf(after(paste(document, "c", '{"state": "X"}', newIds())), "c")).toEqual(["D", "E", "X"]);
    const ports = after(paste(document, "a", '{"name": "done", "when": "True"}', newIds()));
    expect(listOf(ports, "a", "ports").map((id) => field(ports, id, "name"))).toEqual(["done", "done2"]);
  });
  it("sends numbers as they were written", () => {
    const command = paste(document, "root", '{"state": "X", "meta": {"weight": 1.0}}', newIds());
    expect("change" in command && writeExact(command.change)).toContain('"weight":1.0');
  });
  it.each([
    ["hello", "no JSON (syntax)"],
    ["[1]", "(type)"],
    ["{}", "(missing)"],
    ['{"states": []}', "states: "],
    ['{"children": [{"state": 3}]}', "children/0: "],
    ['{"state": "A", "colour": "red"}', "(unknown_field)"],
  ])("says why %s is no element", (text, reason) => expect(reasonOf(paste(document, "root", text, newIds()))).toContain(reason));
});
