import { describe, expect, it } from "vitest";
import { buildTree } from "../../shared/model/modelTree";
import { readModel } from "../../shared/model/readModel";
import { portsRead } from "../../shared/run/portsRead";
import { askedOf, askedText, isSameAsked, subjectQuery } from "../../shared/run/subject";

describe("what is asked about", () => {
  it("is asked for by its address, its number or its name", () => {
    expect(subjectQuery({ port: "Root/A.success" })).toBe("port=Root%2FA.success");
    expect(subjectQuery({ state: "Root/A", action: 0 })).toBe("state=Root%2FA&action=0");
    expect(subjectQuery({ state: "Root/A", parameter: "größe" })).toBe("state=Root%2FA&parameter=gr%C3%B6%C3%9Fe");
  });
  it("comes out of an address as it went in, and else not at all", () => {
    for (const asked of [{ action: 12 }, { parameter: "width" }]) expect(askedOf(askedText(asked))).toEqual(asked);
    for (const text of [undefined, "", "action.", "action.-1", "par.", "width"]) expect(askedOf(text)).toBeUndefined();
    expect([isSameAsked({ action: 0 }, { action: 0 }), isSameAsked(undefined, undefined), isSameAsked({ action: 0 }, { parameter: "0" })]).toEqual([true, true, false]);
  });
});

describe("the ports that a part of a condition reads", () => {
  const tree = buildTree(readModel({ rcm: 1, root: { state: "R", first: "A", children: [{ state: "A", ports: [{ name: "done", when: "True" }] }] } }).root);
  it("are those of its children that there are", () => {
    expect(portsRead(tree, "R", "chi.A.port.done and not chi.B.port.done")).toEqual(["R/A.done"]);
    expect(portsRead(tree, "R", "'chi.A.port.done'")).toEqual([]);
    expect(portsRead(tree, "R/Gone", "chi.A.port.done")).toEqual([]);
  });
});
