// A document of 2000 states in the page that edits: drawn at every zoom with few elements, and used as a small one.
import type { Page } from "playwright-core";
import { bundleSize } from "../bench/pages/bundle";
import { largeDocument } from "../bench/pages/large_document.mjs";
import { openFixture, settled, web, type Fixture } from "./fixture";
import { kPatience } from "./patience";

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
  await fixture.send("PUT", "/documents/large", largeDocument(200));
  await page.goto(`${fixture.url}/pro/?edit=large`);
  await settled(page);
});
afterAll(() => fixture.close());

const elements = () => page.locator("body *").count();
const canvas = () => page.locator(".painted");
const tree = () => page.getByRole("tree", { name: "State tree" });
const row = (path: string) => tree().getByRole("treeitem", { name: path, exact: true });
const kMost = 300;

/** The colours of the bitmap that is shown, counted: a canvas with nothing on it has one. */
const colours = () =>
  page.evaluate(() => {
    const [shown] = [...document.querySelectorAll<HTMLCanvasElement>(".painted > canvas")].slice(1, 3).filter((each) => each.style.visibility === "visible");
    const context = shown && new OffscreenCanvas(shown.width, shown.height).getContext("2d");
    if (shown === undefined || context === null || context === undefined) return 0;
    context.drawImage(shown, 0, 0);
    const { data } = context.getImageData(0, 0, shown.width, shown.height);
    return new Set(new Uint32Array(data.buffer)).size;
  });

/** The share of pixels of what is seen of that bitmap that differ from those at the last call with `keep`. */
const difference = (keep: boolean) =>
  page.evaluate((keep) => {
    const frame = document.querySelector(".painted")?.getBoundingClientRect();
    const [shown] = [...document.querySelectorAll<HTMLCanvasElement>(".painted > canvas")].slice(1, 3).filter((each) => each.style.visibility === "visible");
    const context = new OffscreenCanvas(Math.round(frame?.width ?? 1), Math.round(frame?.height ?? 1)).getContext("2d");
    if (frame === undefined || shown === undefined || context === null) return 1;
    const { left, top } = shown.getBoundingClientRect();
    context.drawImage(shown, -Math.round(frame.left - left), -Math.round(frame.top - top));
    const { data } = context.getImageData(0, 0, context.canvas.width, context.canvas.height);
    const now = new Uint32Array(data.buffer);
    const page = window as { keptPixels?: Uint32Array };
    if (keep) page.keptPixels = now;
    const { keptPixels } = page;
    return keptPixels?.length !== now.length ? 1 : now.reduce((sum, pixel, i) => sum + (pixel === keptPixels[i] ? 0 : 1), 0) / now.length;
  }, keep);

/** What is copied of the bitmap before, after an edit or a movement, is as if all of it were painted: another theme and back paint all. `most`: the share of pixels that may differ. */
async function isAsPaintedAnew(most: number): Promise<void> {
  await settled(page);
  await page.waitForTimeout(600);
  await difference(true);
  // Until it is painted as sharp as it will be.
  await expect.poll(async () => {
    const share = await difference(false);
    await difference(true);
    return share;
  }, { interval: 400 }).toBe(0);
  await page.emulateMedia({ colorScheme: "dark" });
  await expect.poll(() => difference(false)).toBeGreaterThan(0.5);
  await page.emulateMedia({ colorScheme: "light" });
  await expect.poll(() => difference(false)).toBeLessThanOrEqual(most);
}

async function middle(): Promise<{ readonly x: number; readonly y: number }> {
  const box = await canvas().boundingBox();
  if (box === null) throw new Error("there is no canvas");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** The place of an element in the drawing, once it no longer moves. */
async function settledBox(name: string) {
  const element = page.getByRole("group", { name, exact: true });
  let before = "";
  const rests = async () => {
    const [last, now] = [before, JSON.stringify(await element.boundingBox())];
    before = now;
    return now !== "null" && now === last;
  };
  await expect.poll(rests, { interval: 400, timeout: kPatience }).toBe(true);
  const box = await element.boundingBox();
  if (box === null) throw new Error(`${name} is not there`);
  return box;
}

describe("the expert page", () => {
  it("needs at most 500 kB of scripts and styles, compressed, before it shows anything", () => {
    const { files, gzip, brotli } = bundleSize(web, "pro/index.html");
    expect(files.filter((file) => file.endsWith(".js")).length).toBeGreaterThan(1);
    expect(brotli).toBeLessThanOrEqual(gzip);
    expect(gzip).toBeLessThanOrEqual(500_000);
  });
});

describe("a document of 2000 states", () => {
  it("is painted at every zoom, with at most 300 elements in the page", async () => {
    const { x, y } = await middle();
    await page.mouse.move(x, y);
    const seen: number[] = [];
    for (let turn = 0; turn < 14; turn++) {
      await page.mouse.wheel(0, turn === 0 ? 0 : -150);
      await page.waitForTimeout(350);
      await expect.poll(() => colours()).toBeGreaterThan(8);
      seen.push(await elements());
    }
    expect(Math.max(...seen)).toBeLessThanOrEqual(kMost);
    await fixture.screenshot("large-near");
    await page.keyboard.press("Control+0");
    await page.waitForTimeout(500);
    await fixture.screenshot("large-far");
  });

  it("shows a state that was found, and selects what is clicked", async () => {
    await page.getByRole("searchbox", { name: "Search the model" }).fill("Group7");
    await page.keyboard.press("Enter");
    await expect.poll(() => page.locator(".painted .is-selected").getAttribute("data-path")).toBe("Large/Group7");
    await page.getByRole("searchbox", { name: "Search the model" }).fill("");
    await row("Large/Group1/Part1/Step2").getByRole("button").click();
    const box = await settledBox("State Large/Group1/Part1/Step2");
    await page.mouse.click(box.x + box.width * 0.4, box.y - 40);
    await expect.poll(() => row("Large/Group1/Part1/Step2").getAttribute("aria-selected")).toBe("false");
    await page.mouse.click(box.x + box.width * 0.15, box.y + box.height * 0.8);
    await expect.poll(() => row("Large/Group1/Part1/Step2").getAttribute("aria-selected")).toBe("true");
    await fixture.screenshot("large-selected");
  });

  /** Drags at a state, and tells how far it was shown moved before it was dropped, and after. */
  async function drag(button: "left" | "middle"): Promise<readonly (readonly [x: number, y: number])[]> {
    const name = "State Large/Group1/Part1/Step2";
    const before = await settledBox(name);
    const way = async () => {
      const { x, y } = await settledBox(name);
      return [x - before.x, y - before.y] as const;
    };
    const [x, y] = [before.x + before.width * 0.15, before.y + before.height * 0.8];
    await page.mouse.move(x, y);
    await page.mouse.down({ button });
    await page.mouse.move(x + 60, y + 30, { steps: 5 });
    const shown = await way();
    await page.mouse.up({ button });
    return [shown, await way()];
  }

  it("moves with the middle button as far as the pointer, and does not take it for a click", async () => {
    for (const [x, y] of await drag("middle")) {
      expect(x).toBeCloseTo(60, 1);
      expect(y).toBeCloseTo(30, 1);
    }
    await expect.poll(() => row("Large/Group1/Part1/Step2").getAttribute("aria-selected")).toBe("true");
    await page.mouse.move(0, 0);
  });

  it("lets a state be dragged onto the grid, where it is shown before it is dropped; with Alt, as far as the pointer", async () => {
    const [shown, dropped] = await drag("left");
    expect(dropped?.[0]).toBeCloseTo(shown?.[0] ?? 0, 1);
    expect(dropped?.[1]).toBeCloseTo(shown?.[1] ?? 0, 1);
    // At a zoom of 1.1 at most, half of the grid of 4 px.
    expect(Math.abs((dropped?.[0] ?? 0) - 60)).toBeLessThanOrEqual(2.2);
    expect(Math.abs((dropped?.[1] ?? 0) - 30)).toBeLessThanOrEqual(2.2);
    await page.keyboard.down("Alt");
    const [free, placed] = await drag("left");
    await page.keyboard.up("Alt");
    expect(free?.[0]).toBeCloseTo(60, 1);
    expect(free?.[1]).toBeCloseTo(30, 1);
    // A place is in whole pixels of the drawing.
    expect(Math.abs((placed?.[0] ?? 0) - 60)).toBeLessThanOrEqual(0.56);
    expect(Math.abs((placed?.[1] ?? 0) - 30)).toBeLessThanOrEqual(0.56);
    await expect.poll(() => row("Large/Group1/Part1/Step2").getAttribute("aria-selected")).toBe("true");
  });

  it("draws an edit", async () => {
    await page.getByRole("group", { name: "State Large/Group1/Part1/Step2", exact: true }).waitFor();
    await fixture.send("POST", "/documents/large/edits", { compound: { kind: "rename", id: "g0-0-1", name: "Weld" }, author: "Ann", revision: 1 });
    await page.getByRole("group", { name: "State Large/Group1/Part1/Weld", exact: true }).waitFor();
    await isAsPaintedAnew(0);
    await expect.poll(() => row("Large/Group1/Part1/Weld").getAttribute("aria-selected")).toBe("true");
    const { x, y } = await middle();
    await page.mouse.move(x, y);
    await page.mouse.down({ button: "middle" });
    await page.mouse.move(x - 420, y - 210, { steps: 12 });
    await page.mouse.up({ button: "middle" });
    // The edges of letters are painted a little otherwise from another corner.
    await isAsPaintedAnew(0.004);
  });

  it("has a tree for the keyboard, of which only the rows in view are in the page", async () => {
    await row("Large").focus();
    await page.keyboard.press("End");
    await expect.poll(() => page.evaluate(() => document.activeElement?.getAttribute("aria-label"))).toBe("Large/Group10/Part20/Step9");
    await expect.poll(() => tree().getByRole("treeitem").count()).toBeLessThan(60);
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("ArrowLeft");
    await expect.poll(() => row("Large/Group10/Part20").getAttribute("aria-expanded")).toBe("false");
    await expect.poll(() => row("Large/Group10/Part20").getAttribute("aria-posinset")).toBe("20");
    await settled(page);
    await page.keyboard.press("Enter");
    await expect.poll(() => row("Large/Group10/Part20").getAttribute("aria-selected")).toBe("true");
  });

  it("enters a composite by a double click with Ctrl", async () => {
    const box = await settledBox("State Large/Group10/Part20");
    await page.keyboard.down("Control");
    await page.mouse.dblclick(box.x + box.width * 0.15, box.y + box.height * 0.4);
    await page.keyboard.up("Control");
    await expect.poll(() => page.getByRole("navigation", { name: "Breadcrumb" }).innerText()).toContain("Part20");
    await settled(page);
    await page.getByRole("group", { name: "State Large/Group10/Part20/Step9", exact: true }).waitFor();
  });
});

describe("a run of it, with 200 changes in a second", () => {
  const runStatus = () => page.getByRole("status", { name: "Run status" });
  const step = async () => Number(/step (\d+)/.exec(await runStatus().innerText())?.[1] ?? 0);

  beforeAll(async () => {
    const { id } = (await fixture.send("POST", "/cores", { document: "large" })) as { readonly id: string };
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await page.getByRole("tab", { name: "Derivation" }).click();
    await page.getByRole("button", { name: "Expand all" }).click();
    await page.locator('.canvas[aria-busy="false"] .painted').waitFor({ timeout: 150_000 });
    await fixture.send("POST", `/cores/${id}/start`);
  }, 200_000);

  it("is painted at every zoom, with at most 300 elements, while its states change", async () => {
    const { x, y } = await middle();
    await page.mouse.move(x, y);
    const begun = await step();
    const seen: number[] = [];
    for (let turn = 0; turn < 14; turn++) {
      await page.mouse.wheel(0, turn === 0 ? 0 : -150);
      await page.waitForTimeout(350);
      seen.push(await elements());
    }
    expect(Math.max(...seen)).toBeLessThanOrEqual(kMost);
    expect(await page.locator(".running li").count()).toBeLessThanOrEqual(13);
    await expect.poll(step).toBeGreaterThan(begun + 100);
    await fixture.screenshot("large-run");
  });

  it("is drawn anew once a frame, however many steps come", async () => {
    const counts = page.evaluate(
      () =>
        new Promise<{ readonly frames: number; readonly changes: number }>((resolve) => {
          let [frames, changes] = [0, 0];
          const status = document.querySelector('[aria-label="Run status"]');
          if (status === null) throw new Error("there is no status");
          // Its records of one frame come together.
          new MutationObserver(() => changes++).observe(status, { subtree: true, characterData: true, childList: true });
          const frame = () => (++frames < 60 || changes < 5 ? requestAnimationFrame(frame) : resolve({ frames, changes }));
          requestAnimationFrame(frame);
        }),
    );
    const { frames, changes } = await counts;
    expect(changes).toBeLessThanOrEqual(frames + 1);
  });

  it("shows the last state when it is stopped", async () => {
    await page.getByRole("button", { name: "Pause" }).click();
    await expect.poll(() => runStatus().innerText()).toContain("Paused");
    const id = new URL(page.url()).searchParams.get("run") ?? "";
    const stored = (await fixture.send("GET", `/cores/${id}`)) as { readonly step: number };
    await expect.poll(step).toBe(stored.step);
  });
});
