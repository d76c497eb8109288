import { describe, expect, it } from "vitest";
import { boundsOf, kUsualPanels, panelNames, panelShapes, shownSizes, sizeByKey, type Panels } from "../../shared/layout/panels";
import { panelsText, readPanels } from "../../shared/layout/stored";

const kWindows = [{ width: 820, height: 500 }, { width: 1366, height: 768 }, { width: 2560, height: 1440 }];
const sized = (sizes: Panels["sizes"]): Panels => ({ ...kUsualPanels, sizes });
const huge = sized(Object.fromEntries(panelNames.map((name) => [name, 5000])));

describe("sizes of panels", () => {
  it.each(kWindows)("leave room for the workspace in a window of $width by $height, whatever was set", (window) => {
    for (const panels of [kUsualPanels, huge, sized(Object.fromEntries(panelNames.map((name) => [name, 1])))]) {
      const shown = shownSizes(panels, window);
      expect(window.width - shown.left - shown.right).toBeGreaterThanOrEqual(320);
      expect(window.height - 92 - shown.drawer).toBeGreaterThanOrEqual(170);
      expect(window.width - shown.steps - shown.inference).toBeGreaterThanOrEqual(220);
      for (const name of panelNames) expect(shown[name]).toBeGreaterThanOrEqual(panelShapes[name].least);
    }
  });
  it("are as they were set, again, once the window is large enough", () => {
    const panels = sized({ left: 600 });
    expect(shownSizes(panels, { width: 900, height: 800 }).left).toBeLessThan(600);
    expect(shownSizes(panels, { width: 2560, height: 1440 }).left).toBe(600);
  });
  it("grow with a wide screen", () => {
    const [small, wide] = [shownSizes(kUsualPanels, { width: 1366, height: 768 }), shownSizes(kUsualPanels, { width: 2560, height: 1440 })];
    expect([small.left, small.right]).toEqual([236, 300]);
    expect(wide.left).toBeGreaterThan(small.left);
    expect(wide.right).toBeGreaterThan(small.right);
  });
  it("have the room of a panel that is folded away", () => {
    const window = { width: 1366, height: 768 };
    const folded: Panels = { ...kUsualPanels, folded: new Set(["right"]) };
    expect(boundsOf("left", folded, window).most).toBe(boundsOf("left", kUsualPanels, window).most + 300);
  });
});

describe("keys of a splitter", () => {
  const bounds = { least: 150, most: 400 };
  it.each<[string, boolean, string, number | undefined]>([
    ["ArrowRight", false, "ArrowRight", 216],
    ["ArrowLeft", false, "ArrowRight", 184],
    ["ArrowLeft", false, "ArrowLeft", 216],
    ["ArrowUp", true, "ArrowUp", 280],
    ["ArrowDown", true, "ArrowUp", 150],
    ["Home", false, "ArrowUp", 150],
    ["End", false, "ArrowUp", 400],
    ["ArrowUp", false, "ArrowRight", undefined],
    ["a", false, "ArrowRight", undefined],
  ])("%s, with Shift: %s, where %s makes it larger, give %s", (key, shift, grows, size) => expect(sizeByKey(200, key, shift, grows, bounds)).toBe(size));
});

describe("the stored text", () => {
  it("gives what was stored", () => {
    const panels: Panels = { sizes: { left: 300, drawer: 220 }, folded: new Set(["right"]), cell: "half", cellShown: false };
    expect(readPanels(panelsText(panels))).toEqual(panels);
  });
  it.each([null, "", "no JSON", "[]", "7", '{"sizes":7,"folded":{},"cell":"moon"}', '{"sizes":{"left":-4,"right":"wide","attic":9},"folded":["attic"]}'])("is as usual where it is %s", (text) => {
    expect(readPanels(text)).toEqual(kUsualPanels);
  });
});
