// The frame of the page: borders between panels, panels that are folded away, the place of the cell, following, and the legend.
import type { Page } from "playwright-core";
import { findings } from "./axe";
import { dragTo } from "./hands";
import { openFixture, settled, type Fixture } from "./fixture";

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
  const { id } = (await fixture.send("POST", "/cores", { document: "pick" })) as { readonly id: string };
  await page.goto(`${fixture.url}/pro/?run=${id}`);
  await settled(page);
  // The cell in 3D takes most of the time of the machine.
  await page.getByRole("button", { name: "Close the cell view" }).click();
});
afterAll(() => fixture.close());

const border = (name: string) => page.getByRole("separator", { name });
const size = async (name: string) => Number(await border(name).getAttribute("aria-valuenow"));
const boxOf = async (selector: string) => {
  const box = await page.locator(selector).boundingBox();
  if (box === null) throw new Error(`${selector} is not on the screen`);
  return box;
};

async function dragBorder(name: string, by: { readonly x: number; readonly y: number }): Promise<void> {
  const box = await border(name).boundingBox();
  if (box === null) throw new Error(`${name} is not on the screen`);
  // Beside the middle, where the button that folds is.
  const from = { x: box.x + box.width / 2, y: box.y + Math.min(60, box.height / 2) };
  await dragTo(page, from, { x: from.x + by.x, y: from.y + by.y });
  await page.mouse.up();
}

describe("a border between panels", () => {
  it("is dragged by the mouse, and the panel and the drawing take the room", async () => {
    const [left, canvas] = [await boxOf(".side-left"), await boxOf(".canvas")];
    await dragBorder("Width of the left panel", { x: 70, y: 0 });
    await expect.poll(async () => (await boxOf(".side-left")).width).toBe(left.width + 70);
    await expect.poll(async () => (await boxOf(".canvas")).width).toBe(canvas.width - 70);
    const drawer = await size("Height of the panel below");
    await dragBorder("Height of the panel below", { x: 0, y: -90 });
    await expect.poll(() => size("Height of the panel below")).toBe(drawer + 90);
    await fixture.screenshot("layout-borders");
  });

  it("is given up by Esc while it is dragged", async () => {
    const before = await size("Width of the right panel");
    const box = await boxOf(".splitter-right");
    await dragTo(page, { x: box.x + 4, y: box.y + 40 }, { x: box.x - 120, y: box.y + 40 });
    await expect.poll(() => size("Width of the right panel")).toBe(before + 124);
    await page.keyboard.press("Escape");
    await page.mouse.up();
    await expect.poll(() => size("Width of the right panel")).toBe(before);
  });

  it("is moved by arrows, Home and End, within bounds that leave room for the drawing", async () => {
    const right = border("Width of the right panel");
    await right.focus();
    const before = await size("Width of the right panel");
    await page.keyboard.press("ArrowLeft");
    await expect.poll(() => size("Width of the right panel")).toBe(before + 16);
    await page.keyboard.press("End");
    await expect.poll(async () => (await boxOf(".workspace")).width).toBeGreaterThanOrEqual(320);
    await page.keyboard.press("Home");
    await expect.poll(() => size("Width of the right panel")).toBe(Number(await right.getAttribute("aria-valuemin")));
    await right.dblclick({ position: { x: 4, y: 30 } });
    await expect.poll(() => size("Width of the right panel")).toBe(before);
  });

  it("shows a smaller panel only while the window is smaller", async () => {
    const left = await size("Width of the left panel");
    await page.setViewportSize({ width: 820, height: 500 });
    await expect.poll(() => size("Width of the left panel")).toBeLessThan(left);
    await expect.poll(async () => (await boxOf(".workspace")).width).toBeGreaterThanOrEqual(320);
    await page.setViewportSize({ width: 1600, height: 1000 });
    await expect.poll(() => size("Width of the left panel")).toBe(left);
  });

  it("is dragged by a finger", async () => {
    const cdp = await page.context().newCDPSession(page);
    await cdp.send("Emulation.setTouchEmulationEnabled", { enabled: true });
    const before = await size("Width of the left panel");
    const box = await boxOf(".splitter-left");
    const from = box.x + box.width / 2;
    const touch = (type: "touchStart" | "touchMove" | "touchEnd", x: number) =>
      cdp.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x, y: box.y + 60 }] });
    await touch("touchStart", from);
    for (const by of [10, 25, 40]) await touch("touchMove", from + by);
    await touch("touchEnd", from + 40);
    await expect.poll(() => size("Width of the left panel")).toBe(before + 40);
    await cdp.send("Emulation.setTouchEmulationEnabled", { enabled: false });
    await cdp.detach();
  });
});

describe("a side panel", () => {
  it("is folded away by key and button, and comes back; sizes and folds are kept over a reload", async () => {
    const [left, drawer] = [await size("Width of the left panel"), await size("Height of the panel below")];
    await page.keyboard.press("Control+,");
    await expect.poll(() => page.locator(".side-left").count()).toBe(0);
    await expect.poll(async () => (await boxOf(".workspace")).x).toBe(0);
    await page.getByRole("button", { name: "The right panel" }).click();
    await expect.poll(() => page.locator(".side-right").count()).toBe(0);
    await page.reload();
    await settled(page);
    await expect.poll(async () => (await boxOf(".workspace")).width).toBe(1600);
    await fixture.screenshot("layout-folded");
    await border("Width of the right panel").focus();
    await page.keyboard.press("Enter");
    await page.locator(".side-right").waitFor();
    await page.keyboard.press("Control+f");
    await page.locator("#search:focus").waitFor();
    await expect.poll(async () => [await size("Width of the left panel"), await size("Height of the panel below")]).toEqual([left, drawer]);
  });

  it("below a run is closed and opened by key, with what it showed", async () => {
    await page.getByRole("tab", { name: "Log" }).click();
    await page.keyboard.press("Control+j");
    await expect.poll(() => page.locator(".drawer").count()).toBe(0);
    await page.keyboard.press("Control+j");
    await page.getByRole("region", { name: "Log" }).waitFor();
  });
});

describe("the cell beside a task", () => {
  it("is moved into a half of the workspace, made larger, kept there, and moved back", async () => {
    await page.getByRole("button", { name: "Cell view" }).click();
    await page.getByRole("button", { name: "Beside the drawing" }).click();
    await expect.poll(async () => {
      const [canvas, cell] = [await boxOf(".canvas"), await boxOf(".cell-dock")];
      return canvas.x + canvas.width - cell.x;
    }).toBe(0);
    const cell = await boxOf(".cell-dock");
    await dragBorder("Width of the cell view", { x: -100, y: 0 });
    await expect.poll(async () => (await boxOf(".cell-dock")).width).toBe(cell.width + 100);
    await page.getByText(/^cell time/).waitFor();
    await page.waitForTimeout(1200);
    await fixture.screenshot("layout-cell-half");
    await page.getByRole("button", { name: "Below the properties" }).click();
    const height = (await boxOf(".cell-dock")).height;
    await border("Height of the cell view").focus();
    await page.keyboard.press("ArrowUp");
    await expect.poll(async () => (await boxOf(".cell-dock")).height).toBe(height + 16);
  });

  it("is shown as the whole page, which is in the address", async () => {
    await page.getByRole("button", { name: "As the whole page" }).click();
    await page.getByRole("tab", { name: "Cell", selected: true }).waitFor();
    await expect.poll(() => new URL(page.url()).searchParams.get("page")).toBe("cell");
    await page.reload();
    await page.getByRole("tab", { name: "Cell", selected: true }).waitFor();
    await page.getByRole("tab", { name: "Task" }).click();
    await expect.poll(() => new URL(page.url()).searchParams.get("page")).toBeNull();
    // It is where it was.
    await expect.poll(async () => (await boxOf(".cell-dock.is-column")).height).toBeGreaterThan(100);
    await page.getByRole("button", { name: "Close the cell view" }).click();
    await expect.poll(() => page.locator(".cell-dock").count()).toBe(0);
  });
});

describe("following a run", () => {
  const follow = () => page.getByRole("button", { name: "Follow", exact: true });
  const isInView = (path: string) =>
    page.evaluate((at) => {
      const [frame, box] = [document.querySelector(".canvas")?.getBoundingClientRect(), document.querySelector(`.canvas [data-path="${at}"]`)?.getBoundingClientRect()];
      return frame !== undefined && box !== undefined && box.width > 0 && box.left >= frame.left && box.top >= frame.top && box.right <= frame.right && box.bottom <= frame.bottom;
    }, path);
  /** Height of the letters of a port on the screen [px]. */
  const letters = (address: string) =>
    page.locator(`[data-address="${address}"] .port-name`).evaluate((name: HTMLElement) => (parseFloat(getComputedStyle(name).fontSize) * name.getBoundingClientRect().width) / name.offsetWidth);
  const kActive = "Long/Far/Last/Here";

  beforeAll(async () => {
    // A row of states that is too long to be read as a whole; its last one is active, inside of two others.
    const child = (i: number) => ({ state: `Step${i}`, ports: [{ name: "done", when: "False", to: i < 29 ? `Step${i + 1}` : "Far" }] });
    const far = { state: "Far", first: "Last", ports: [{ name: "out", when: "chi.Last.port.over" }], children: [{ state: "Last", first: "Here", ports: [{ name: "over", when: "False" }], children: [{ state: "Here", ports: [{ name: "done", when: "False" }] }] }] };
    await fixture.send("PUT", "/documents/long", { rcm: 1, root: { state: "Long", first: "Far", children: [...Array.from({ length: 30 }, (_, i) => child(i)), far] } });
    const { id } = (await fixture.send("POST", "/cores", { document: "long" })) as { readonly id: string };
    await page.setViewportSize({ width: 1366, height: 768 });
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(page);
    await fixture.send("POST", `/cores/${id}/start`);
  });

  it("is off at first, and says that the ports are too small to be read", async () => {
    await page.getByRole("button", { name: "Collapse Long/Far", exact: true }).click();
    await settled(page);
    await expect.poll(() => follow().getAttribute("aria-pressed")).toBe("false");
    await page.getByRole("button", { name: "Zoom in to read the ports" }).waitFor();
    expect(await isInView(kActive)).toBe(false);
    await fixture.screenshot("layout-small");
  });

  it("opens what is active and moves there, so that its ports can be read; the address says that it does", async () => {
    await follow().click();
    await expect.poll(() => isInView(kActive)).toBe(true);
    await settled(page);
    await expect.poll(() => letters(`${kActive}.done`)).toBeGreaterThanOrEqual(9.9);
    await expect.poll(() => new URL(page.url()).searchParams.get("follow")).toBe("1");
    await fixture.screenshot("layout-follow");
    await page.reload();
    await expect.poll(() => isInView(kActive)).toBe(true);
    await settled(page);
    await expect.poll(() => letters(`${kActive}.done`)).toBeGreaterThanOrEqual(9.9);
    await expect.poll(() => follow().getAttribute("aria-pressed")).toBe("true");
  });

  it("keeps it in view when the room changes", async () => {
    await page.setViewportSize({ width: 1000, height: 700 });
    await page.waitForTimeout(300);
    await expect.poll(() => isInView(kActive)).toBe(true);
    await page.setViewportSize({ width: 1366, height: 768 });
    await page.waitForTimeout(300);
    await expect.poll(() => isInView(kActive)).toBe(true);
  });

  it("ends when the drawing is moved by hand, and begins again by key", async () => {
    const box = await boxOf(".canvas");
    await dragTo(page, { x: box.x + 60, y: box.y + box.height / 2 }, { x: box.x + 160, y: box.y + box.height / 2 + 60 });
    await page.mouse.up();
    await expect.poll(() => follow().getAttribute("aria-pressed")).toBe("false");
    await expect.poll(() => new URL(page.url()).searchParams.get("follow")).toBeNull();
    await page.keyboard.press("Control+0");
    await expect.poll(() => letters(`${kActive}.done`)).toBeLessThan(9.9);
    await page.keyboard.press("Control+Shift+Space");
    await expect.poll(() => letters(`${kActive}.done`)).toBeGreaterThanOrEqual(9.9);
    await expect.poll(() => follow().getAttribute("aria-pressed")).toBe("true");
  });

  it("begins while the drawing still moves to where its ports cannot be read", async () => {
    await follow().click();
    await expect.poll(() => follow().getAttribute("aria-pressed")).toBe("false");
    await page.keyboard.press("Control+0");
    await page.keyboard.press("Control+Shift+Space");
    await page.waitForTimeout(800);
    await expect.poll(() => letters(`${kActive}.done`)).toBeGreaterThanOrEqual(9.9);
    await expect.poll(() => isInView(kActive)).toBe(true);
  });
});

describe("the browser's Back", () => {
  it("leads to the page before, and Forward to the one after, with the run", async () => {
    const shown = () => page.getByRole("tablist", { name: "Pages" }).getByRole("tab", { selected: true }).innerText();
    const run = new URL(page.url()).searchParams.get("run");
    await page.getByRole("tab", { name: "Services" }).click();
    await page.getByRole("tab", { name: "Cell", exact: true }).click();
    await page.goBack();
    await expect.poll(shown).toBe("Services");
    await page.goBack();
    await expect.poll(shown).toBe("Task");
    await expect.poll(() => new URL(page.url()).searchParams.get("run")).toBe(run);
    await page.goForward();
    await expect.poll(shown).toBe("Services");
    await page.goBack();
    await settled(page);
  });
});

describe("room for what is drawn", () => {
  const heightOf = (text: string) => page.getByRole("article", { name: "Service display" }).locator(".rsm-state text", { hasText: text }).evaluate((at) => at.getBoundingClientRect().height);

  it("is used by the drawing of a large RSM on a wide screen, up to the size at which it was drawn", async () => {
    await page.setViewportSize({ width: 2560, height: 1440 });
    await page.getByRole("tab", { name: "Services" }).click();
    await expect.poll(() => heightOf("Asking")).toBeGreaterThan(12);
    await fixture.screenshot("layout-services-2560");
    await page.goBack();
    await page.setViewportSize({ width: 1600, height: 1000 });
    await settled(page);
  });

  it("is shared with the cell in half of a small window: the tools stay in one row, and the detail is chosen from a list", async () => {
    await page.setViewportSize({ width: 1366, height: 768 });
    await page.getByRole("button", { name: "Cell view" }).click();
    await page.getByRole("button", { name: "Beside the drawing" }).click();
    await border("Width of the cell view").dblclick({ position: { x: 4, y: 30 } });
    await settled(page);
    const tools = page.getByRole("toolbar", { name: "Drawing" });
    const tops = () => tools.locator(":scope > :visible").evaluateAll((all) => all.map((each) => each.getBoundingClientRect()).map(({ top, height }) => Math.round(top + height / 2)));
    await expect.poll(async () => new Set(await tops()).size).toBe(1);
    await expect.poll(() => tools.evaluate((row) => row.scrollWidth - row.clientWidth)).toBe(0);
    await tools.getByRole("combobox", { name: "Detail" }).selectOption("Conditions");
    await settled(page);
    await expect.poll(() => page.getByRole("button", { name: "Zoom in to read the ports" }).count()).toBe(0);
    await fixture.screenshot("layout-half-1366");
    await page.getByRole("button", { name: "Below the properties" }).click();
    await page.getByRole("button", { name: "Close the cell view" }).click();
    await page.setViewportSize({ width: 1600, height: 1000 });
    await settled(page);
  });
});

describe("the legend", () => {
  it("is opened beside the drawing, draws its signs as the canvas does, and is closed by Esc", async () => {
    await page.getByRole("button", { name: "Legend" }).first().click();
    const legend = page.getByRole("region", { name: "Legend" });
    await legend.waitFor();
    const colour = (selector: string) => page.locator(selector).first().evaluate((each) => getComputedStyle(each).borderTopColor);
    // What has become active flashes.
    await expect.poll(async () => (await colour('[data-sign="active"] .state')) === (await colour(".react-flow .state.is-active"))).toBe(true);
    expect(await legend.locator('[data-sign="line_exit"] path').evaluate((each) => getComputedStyle(each).strokeDasharray)).toBe(await page.locator(".react-flow .line-exit path").first().evaluate((each) => getComputedStyle(each).strokeDasharray));
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("layout-legend");
    await page.keyboard.press("Escape");
    await expect.poll(() => legend.count()).toBe(0);
  });

  it("is a page of the help", async () => {
    await page.goto(`${fixture.url}/pro/?help=signs`);
    await page.getByRole("dialog", { name: "Help" }).getByText("Deep history: the same in all states within.").waitFor();
    await fixture.screenshot("layout-help-legend");
    await page.keyboard.press("Escape");
  });
});
