import { describe, expect, it } from "vitest";
import { conditionText, leafBoxes, nameRoom, nameWidth, portNameRoom, portSize } from "../../shared/drawing/measure";
import type { DrawnNode } from "../../shared/drawing/drawing";
import type { State } from "../../shared/model/model";

/** What Chromium measures of Inter 650 at 13 px. */
const kMeasured: Readonly<Record<string, number>> = {
  Calibration: 68.9, CameraCalibration: 118.1, success: 52.6, to_Calibration: 87, by_hand: 52.9, ShowPart: 61.2, HasCalibration: 93.3, Demonstrator: 87,
};
const leafState = (name: string, ports: readonly string[]): State => ({
  kind: "state", name, parameters: [], results: [], variables: [], actions: [], children: [], ports: ports.map((port) => ({ name: port, when: "True" })),
});
function drawn(name: string, side: "EAST" | "SOUTH", composite: boolean): DrawnNode {
  const state = leafState(name, ["success", "error"]);
  const { size, ports } = leafBoxes(state, side, "slim");
  const boxes = ports.map((box, i) => ({ ...box, address: "", name: state.ports[i]?.name ?? "", condition: "", when: "", timed: false, exits: true }));
  return { kind: "state", path: name, name, depth: 1, x: 0, y: 0, ...size, composite, open: false, lines: [], ports: boxes, side };
}

describe("nameWidth", () => {
  it.each(Object.entries(kMeasured))("is no less than what %s takes, and not much more", (name, width) => {
    expect(nameWidth(name, 13)).toBeGreaterThanOrEqual(width);
    expect(nameWidth(name, 13)).toBeLessThan(1.15 * width);
  });
});

describe("names far out", () => {
  it.each(Object.keys(kMeasured))("%s has room to be written larger, with ports to either side and a button", (name) => {
    for (const side of ["EAST", "SOUTH"] as const) {
      const node = drawn(name, side, true);
      expect(nameRoom(node)).toBeGreaterThanOrEqual(1.2);
      for (const port of node.ports) expect(portNameRoom(port)).toBeGreaterThanOrEqual(1.15);
    }
  });
});

describe("a port with a time-out", () => {
  const port = { name: "success", after: "par.timeout" } as const;
  it("has room for a clock before its name, also far out", () => {
    for (const detail of ["slim", "ports"] as const) {
      const { width } = portSize(port, detail);
      expect(width).toBeGreaterThanOrEqual(kMeasured["success"] ?? Infinity);
      expect(width).toBeGreaterThanOrEqual(portSize({ name: "success", when: "" }, detail).width + 11);
      const room = portNameRoom({ ...port, x: 0, y: 0, width, height: 29, address: "", condition: "", when: "", timed: true, exits: true });
      expect(room).toBeGreaterThanOrEqual(detail === "slim" ? 1.15 : 1);
    }
  });
  it("has its time-out written beneath", () => {
    expect(conditionText(port)).toBe("after par.timeout s");
    expect(conditionText({ name: "late", after: "par.timeout + par.more + 1" })).toHaveLength(28);
  });
});

describe("a dispatcher", () => {
  it("is small, and as long as its ways need", () => {
    const sign = (ways: number) => leafBoxes({ ...leafState("Dispatcher", Array.from({ length: ways }, (_, i) => `to_State${i}`)), dispatcher: "choice" }, "EAST", "full");
    expect([sign(2).size, sign(1).size]).toEqual([{ width: 40, height: 40 }, { width: 40, height: 40 }]);
    const { size, ports } = sign(9);
    expect(size.width).toBe(40);
    ports.forEach((dot, i) => {
      expect(dot.y).toBeGreaterThanOrEqual(i === 0 ? 0 : (ports[i - 1]?.y ?? 0) + dot.height);
      expect(dot.y + dot.height).toBeLessThanOrEqual(size.height);
    });
  });
});
