import { describe, expect, it } from "vitest";
import * as schema from "../../generated/validators";
import { check } from "../../shared/messages/check";
import { buildTree } from "../../shared/model/modelTree";
import { readModel } from "../../shared/model/readModel";
import { activityOf, pointerAt, type Doing } from "../../shared/presence/activity";
import { readJson } from "../files";
import { checkExample } from "../schemas";

const document = readJson(new URL("../../../api/examples/document.ids.json", import.meta.url));
const tree = buildTree(readModel(check(schema.native, { document, origin: {} }).document).root);
const nothing: Doing = { name: "Ada", tree, view: { selection: undefined, also: new Set(), focus: undefined }, text: undefined, pointer: undefined };
const kCount = "9b1deb4d-3b7d-4bad-9bdd-2b0d7b3dcb6d";

describe("activityOf", () => {
  it("of somebody who only looks is their name and the level they see", () => {
    expect(activityOf(nothing)).toEqual({ name: "Ada", level: "root" });
    expect(activityOf({ ...nothing, view: { ...nothing.view, focus: "Root/Count" } }).level).toBe(kCount);
    expect(activityOf({ ...nothing, tree: undefined })).toEqual({ name: "Ada" });
  });

  it("has what is selected by ids, a node with those selected besides, or a port", () => {
    const node = { kind: "node" as const, path: "Root/Count" };
    expect(activityOf({ ...nothing, view: { ...nothing.view, selection: node, also: new Set(["Root/End"]) } }).selection).toEqual([kCount, "end"]);
    expect(activityOf({ ...nothing, view: { ...nothing.view, selection: { kind: "port", address: "Root/End.success" } } }).selection).toEqual(["yTg6"]);
    expect(activityOf({ ...nothing, view: { ...nothing.view, selection: { kind: "node", path: "Root/Gone" } } })).not.toHaveProperty("selection");
  });

  it("stays within what the server accepts", () => {
    const also = new Set(Array.from({ length: 40 }, () => "Root/End"));
    const states = Array.from({ length: 50 }, (_, i) => ({ state: `S${i}`, meta: { id: `s${i}` } }));
    const wide = buildTree(readModel(check(schema.native, { document: { rcm: 1, root: { state: "R", first: "S0", children: states, meta: { id: "r" } } }, origin: {} }).document).root);
    const all = [...wide.keys()].slice(1);
    const view = { ...nothing.view, selection: { kind: "node" as const, path: all[0] ?? "" }, also: new Set([...also, ...all.slice(1)]) };
    const activity = activityOf({ ...nothing, tree: wide, view, text: { element: "s1", field: "entry", offset: 3e6 }, pointer: pointerAt("s1", { x: 10, y: 20 }, { x: 12.345, y: 18 }) });
    expect(activity.selection).toHaveLength(32);
    expect(activity.pointer).toEqual({ element: "s1", x: 2.3, y: -2 });
    expect(() => checkExample("stream_request", { type: "presence", document: "task", ...activity })).not.toThrow();
  });
});
