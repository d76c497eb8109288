// More detail is tried where it may be readable, and not where texts alone would fill the canvas.
import ELK from "elkjs/lib/elk.bundled.js";
import { describe, expect, it } from "vitest";
import type { ElkGraph, LayoutEngine } from "../../shared/drawing/elk";
import { readable } from "../../shared/drawing/fit";
import { layoutModel } from "../../shared/drawing/layout";
import type { Detail } from "../../shared/drawing/measure";
import { mayBeReadable } from "../../shared/drawing/moreDetail";
import { buildTree } from "../../shared/model/modelTree";
import { modelOf } from "../conformance";

const elk = new ELK();
const engine: LayoutEngine = async (graph) => (await elk.layout(graph as Parameters<typeof elk.layout>[0])) as ElkGraph;
const large = { width: 2200, height: 1300 };

describe.each(["thesis-pick", "thesis-object-recognition", "thesis-search-object-found", "thesis-collision-history"])("of %s", async (name) => {
  const { root } = modelOf(name);
  const tree = buildTree(root);
  const draw = (detail: Detail) => layoutModel(engine, { state: root, path: root.name, collapsed: new Set(), detail, aspect: 1.4 });
  const [slim, ports, full] = [await draw("slim"), await draw("ports"), await draw("full")];

  it("what can be read with more detail is tried on a large canvas", () => {
    if (readable(ports, large)) expect(mayBeReadable(slim, tree, "slim", "ports", large)).toBe(true);
    if (readable(full, large)) expect(mayBeReadable(ports, tree, "ports", "full", large)).toBe(true);
    expect(readable(ports, large)).toBe(true);
  });

  it("nothing is tried on a canvas on which not even less can be read", () => {
    const small = { width: slim.width * 0.6, height: slim.height * 0.6 };
    expect(readable(slim, small)).toBe(false);
    expect(mayBeReadable(slim, tree, "slim", "ports", small)).toBe(false);
  });
});

it("what would be far too large is not tried", async () => {
  const { root } = modelOf("thesis-pick");
  const ports = await layoutModel(engine, { state: root, path: root.name, collapsed: new Set(), detail: "ports", aspect: 1.4 });
  const just = { width: ports.width * 0.7 + 28, height: ports.height * 0.7 + 64 };
  expect(readable(ports, just)).toBe(true);
  expect(mayBeReadable(ports, buildTree(root), "ports", "full", just)).toBe(false);
});
