// Placing states with the mouse and with keys, and notes, on the real server: what is placed stays, also for others, and is taken back.
import type { Locator, Page } from "playwright-core";
import { openFixture, settled, type Fixture } from "./fixture";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
  const port = (name: string, to?: string) => ({ name, when: "True", ...(to !== undefined && { to }) });
  const inner = [{ state: "Reach", ports: [port("done", "Hold")] }, { state: "Hold" }];
  const children = [
    { state: "Approach", ports: [port("done", "Grasp"), port("failed", "Recover")] },
    { state: "Grasp", first: "Reach", children: inner, ports: [port("done", "Retreat"), port("failed", "Recover")] },
    { state: "Retreat", ports: [port("done")] },
    { state: "Recover", ports: [port("again", "Approach")] },
  ];
  await fixture.send("PUT", "/documents/task", { rcm: 1, root: { state: "Root", first: "Approach", children, ports: [{ name: "done", when: "chi.Retreat.port.done" }] } });
  await fixture.page.goto(`${fixture.url}/pro/?edit=task`);
  await settled(fixture.page);
});
afterAll(() => fixture.close());

interface Stored {
  readonly document: { readonly layout?: Readonly<Record<string, { readonly x: number; readonly y: number }>>; readonly meta?: { readonly notes?: Readonly<Record<string, string>> } };
}
const stored = async () => ((await fixture.send("GET", "/documents/task")) as Stored).document;
const node = (page: Page, path: string): Locator => page.locator(`.react-flow__node [data-path="${path}"]`);

/** Where a node is, from the corner of the outermost state [px of the drawing]. */
async function placeOf(page: Page, path: string): Promise<{ readonly x: number; readonly y: number }> {
  const at = (each: string) => page.locator(`.react-flow__node[data-id="${each}"]`).evaluate((element) => new DOMMatrix(getComputedStyle(element).transform));
  const [outer, inner] = [await at("Root"), await at(path)];
  return { x: inner.e - outer.e, y: inner.f - outer.f };
}

async function drag(page: Page, path: string, by: { readonly x: number; readonly y: number }, drop = true): Promise<void> {
  const box = await node(page, path).boundingBox();
  if (box === null) throw new Error(`${path} is not drawn`);
  const [x, y] = [box.x + 30, box.y + box.height - 5];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + by.x / 2, y + by.y / 2, { steps: 4 });
  await page.mouse.move(x + by.x, y + by.y, { steps: 4 });
  if (drop) await page.mouse.up();
}

describe("a state that is dragged", () => {
  it("is placed where it is dropped, alone, and stays there for others and after a reload", async () => {
    const { page, url, openPage, screenshot } = fixture;
    const before = { retreat: await placeOf(page, "Root/Retreat"), approach: await placeOf(page, "Root/Approach") };
    await drag(page, "Root/Retreat", { x: 60, y: 220 }, false);
    await screenshot("place-dragging");
    await page.mouse.up();
    await expect.poll(async () => Object.keys((await stored()).layout ?? {}).length).toBe(1);
    await settled(page);
    const after = await placeOf(page, "Root/Retreat");
    expect(after.y).toBeGreaterThan(before.retreat.y + 100);
    expect(await placeOf(page, "Root/Approach")).toEqual(before.approach);
    await screenshot("placed");
    await page.reload();
    await settled(page);
    expect(await placeOf(page, "Root/Retreat")).toEqual(after);
    const second = await openPage({ width: 1366, height: 768 });
    await second.goto(`${url}/pro/?edit=task`);
    await settled(second);
    expect(await placeOf(second, "Root/Retreat")).toEqual(after);
    await screenshot("placed-1366", second);
    await second.close();
  });
  it("goes back when Esc is pressed, and when it is undone", async () => {
    const { page } = fixture;
    const placed = await placeOf(page, "Root/Approach");
    await drag(page, "Root/Approach", { x: 0, y: 120 }, false);
    await page.keyboard.press("Escape");
    await page.mouse.up();
    await expect.poll(() => placeOf(page, "Root/Approach")).toEqual(placed);
    await page.getByRole("button", { name: "Undo" }).click();
    await expect.poll(async () => (await stored()).layout).toBeUndefined();
    await settled(page);
  });
  it("moves by keys, and is laid out anew with its level", async () => {
    const { page, screenshot } = fixture;
    await page.getByRole("button", { name: "Keep layout" }).click();
    await expect.poll(async () => Object.keys((await stored()).layout ?? {}).length).toBe(4);
    await settled(page);
    const before = await placeOf(page, "Root/Recover");
    await node(page, "Root/Recover").click({ position: { x: 20, y: 8 } });
    for (let i = 0; i < 3; ++i) await page.keyboard.press("Control+ArrowDown");
    await expect.poll(async () => (await placeOf(page, "Root/Recover")).y).toBe(before.y + 24);
    await screenshot("placed-all");
    await page.keyboard.press("Control+Alt+l");
    await expect.poll(async () => (await stored()).layout).toBeUndefined();
  });
});

describe("a note", () => {
  it("is written at its element, kept and shown", async () => {
    const { page, screenshot } = fixture;
    await settled(page);
    await node(page, "Root/Grasp").click({ position: { x: 20, y: 8 } });
    await page.keyboard.press("Shift+F2");
    await page.getByLabel("Note on Root/Grasp").fill("Force limit 20 N.\nAsk Ann about the new gripper.");
    await page.keyboard.press("Control+Enter");
    await page.getByRole("button", { name: /^Note on Root\/Grasp: Force limit/ }).waitFor();
    await expect.poll(async () => Object.values((await stored()).meta?.notes ?? {})).toEqual(["Force limit 20 N.\nAsk Ann about the new gripper."]);
    await screenshot("note");
    await page.getByRole("button", { name: /^Note on Root\/Grasp/ }).dblclick();
    await page.getByLabel("Note on Root/Grasp").fill("");
    await page.keyboard.press("Control+Enter");
    await expect.poll(async () => (await stored()).meta?.notes).toBeUndefined();
  });
});
