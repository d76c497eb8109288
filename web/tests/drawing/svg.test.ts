import { describe, expect, it } from "vitest";
import type { DrawnNode } from "../../shared/drawing/drawing";
import { drawingSvg, svgText } from "../../shared/drawing/svg";

const port = { address: "Root/Begin.to_Table", name: "to_Table", condition: "", when: "par.begin == 1", timed: false, exits: false, x: 20, y: 4, width: 14, height: 9 };
const node: DrawnNode = { kind: "state", path: "Root/Begin", name: "Begin", depth: 1, composite: false, open: false, lines: [], ports: [port], side: "EAST", x: 0, y: 0, width: 28, height: 40 };
const textsOf = (drawn: DrawnNode) => [...svgText(drawingSvg({ nodes: [drawn], lines: [], width: 60, height: 40 }, { prefix: "p", title: "t" })).matchAll(/<text[^>]*>([^<]*)</g)].map(([, text]) => text);

describe("a state as SVG", () => {
  it("has the names of its ports, but not where it is the sign of an oracle, which has no room for them", () => {
    expect(textsOf(node)).toEqual(["Begin", "to_Table"]);
    expect(textsOf({ ...node, dispatcher: "choice" })).toEqual(["?"]);
  });
  it("has its badge beside its name, smaller, as it was measured", () => {
    const svg = svgText(drawingSvg({ nodes: [{ ...node, width: 200, badge: "oracle par.begin" }], lines: [], width: 200, height: 40 }, { prefix: "p", title: "t" }));
    const [, x] = /<text class="svg-badge" x="([\d.]+)"/.exec(svg) ?? [];
    expect(Number(x)).toBeGreaterThan(11 + 30);
    expect(Number(x)).toBeLessThan(200 - 90);
  });
  it("is XML also where a draft has a name with characters that XML cannot have", () => {
    expect(textsOf({ ...node, name: "\u0000a\u0001b\tc\ud800d\uffff\u{1f916}", ports: [] })).toEqual(["\ufffda\ufffdb\tc\ufffdd\ufffd\u{1f916}"]);
  });
});
