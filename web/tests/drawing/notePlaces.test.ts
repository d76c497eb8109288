import { describe, expect, it } from "vitest";
import type { DrawnLine, DrawnNode, Drawing } from "../../shared/drawing/drawing";
import { noteCorner } from "../../shared/drawing/notePlaces";

const node = (path: string, x: number, y: number, more: Partial<DrawnNode> = {}): DrawnNode => ({
  kind: "state", path, name: path, depth: path.split("/").length - 1, composite: false, open: false, lines: [], ports: [], side: "EAST", x, y, width: 200, height: 80, ...more,
});
const line = (...points: readonly (readonly [number, number])[]): DrawnLine => ({ id: "line", kind: "transition", from: "Root/A.done", to: "Root/B", depth: 1, points: points.map(([x, y]) => ({ x, y })) });
const drawing = (nodes: readonly DrawnNode[], lines: readonly DrawnLine[] = []): Drawing => ({ nodes, lines, width: 1000, height: 1000 });

const root = node("Root", 0, 0, { width: 900, height: 900, open: true, composite: true });
const a = node("Root/A", 100, 300);
const corner = (others: readonly DrawnNode[], lines: readonly DrawnLine[] = []) => noteCorner(drawing([root, a, ...others], lines), "Root/A", a, "Force limit 20 N");

describe("a note", () => {
  it("stands above its element, inside of what that is in", () => expect(corner([])).toBe("above"));
  it("covers neither another node nor a line", () => {
    expect(corner([node("Root/B", 60, 250, { width: 100, height: 40 })])).toBe("above-right");
    expect(corner([], [line([0, 290], [400, 290])])).toBe("below");
    expect(corner([], [line([0, 290], [400, 290]), line([130, 390], [130, 600])])).toBe("below-right");
  });
  it("does not cover the name of the state around it", () => {
    const high = node("Root/A", 100, 34);
    expect(noteCorner(drawing([root, high]), "Root/A", high, "Force limit 20 N")).toBe("below");
  });
  it("is a mark where there is no place", () => expect(corner([], [line([0, 290], [400, 290]), line([0, 390], [400, 390])])).toBeUndefined());
});
