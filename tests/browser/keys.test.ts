// Keys: the help that lists them, and zooming.
import type { Page } from "playwright-core";
import { frames, openFixture, settled, type Fixture } from "./fixture";

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
  await page.goto(`${fixture.url}/pro/`);
  await page.getByRole("combobox", { name: "Document" }).selectOption("pick");
  await page.getByRole("button", { name: "Load" }).click();
  await page.getByRole("group", { name: "State Pick/Release" }).waitFor();
  await settled(page);
});
afterAll(() => fixture.close());

const help = () => page.getByRole("dialog", { name: "Keys and mouse" });

/** Width of a state on the screen [px], once the drawing no longer moves. */
async function shownWidth(): Promise<number> {
  const width = async () => (await page.getByRole("group", { name: "State Pick/Release" }).boundingBox())?.width ?? 0;
  let before = -1;
  await expect
    .poll(async () => {
      await frames(page);
      const [last, now] = [before, await width()];
      before = now;
      return now === last;
    })
    .toBe(true);
  return before;
}

describe("the help", () => {
  it("opens with ?, lists keys and mouse actions, and closes with Esc", async () => {
    await page.keyboard.press("?");
    await help().waitFor();
    const keys = await help().locator("kbd").allInnerTexts();
    expect(keys).toEqual(expect.arrayContaining(["F5", "F7", "F8", "F4", "Shift+F4", "Ctrl++", "Ctrl+-", "Ctrl+0", "Ctrl+Space", "Ctrl+F", "?", "Esc"]));
    for (const gesture of ["Wheel", "Click a port", "Ctrl and double click a composite state"]) expect(await help().innerText()).toContain(gesture);
    await fixture.screenshot("help");
    await page.keyboard.press("Escape");
    await expect.poll(() => help().count()).toBe(0);
  });

  it("closes with Esc without losing what is selected", async () => {
    await page.getByRole("button", { name: "Select Pick/Grasp" }).click();
    const properties = page.getByRole("complementary", { name: "Properties" });
    await expect.poll(() => properties.innerText()).toContain("Grasp");
    await page.keyboard.press("?");
    await help().waitFor();
    await page.keyboard.press("Escape");
    await expect.poll(() => help().count()).toBe(0);
    expect(await properties.innerText()).toContain("Grasp");
    await page.keyboard.press("Escape");
    await expect.poll(() => properties.innerText()).not.toContain("Grasp");
  });

  it("opens with its button, and closes with its own", async () => {
    await page.getByRole("button", { name: "Keys and mouse" }).click();
    await help().waitFor();
    await help().getByRole("button", { name: "Close" }).click();
    await expect.poll(() => help().count()).toBe(0);
  });

  it("does not open by a ? that is typed into a search", async () => {
    const search = page.getByRole("searchbox", { name: "Search the model" });
    await page.keyboard.press("Control+f");
    await page.keyboard.press("?");
    expect(await search.inputValue()).toBe("?");
    expect(await help().count()).toBe(0);
    await search.fill("");
    await search.blur();
  });
});

describe("a double click in the drawing of a run", () => {
  const at = { position: { x: 20, y: 8 } };
  const path = () => page.getByRole("navigation", { name: "Breadcrumb" }).innerText();
  const inProperties = () => page.evaluate(() => document.activeElement?.closest("aside")?.getAttribute("aria-label"));

  it("goes to the properties, with Ctrl it enters, as in the editor", async () => {
    const state = page.locator('.canvas .state[data-path="Pick"]');
    await state.dblclick(at);
    await expect.poll(inProperties).toBe("Properties");
    await expect.poll(() => page.getByRole("complementary", { name: "Properties" }).getByRole("heading", { level: 2 }).innerText()).toBe("Pick");
    await page.locator('.canvas .state[data-path="Pick/Grasp"]').dblclick(at);
    await expect.poll(() => page.getByRole("complementary", { name: "Properties" }).getByRole("heading", { level: 2 }).innerText()).toBe("Grasp");
    const inner = page.locator('.canvas .state[data-path]:not([data-path="Pick"])').filter({ has: page.locator(".state-toggle") }).first();
    const name = await inner.getAttribute("data-path");
    await inner.dblclick(at);
    await expect.poll(inProperties).toBe("Properties");
    expect(await path()).toBe("Pick");
    await inner.dblclick({ ...at, modifiers: ["Control"] });
    await expect.poll(path).toContain(name?.slice("Pick/".length));
    await settled(page);
    await page.getByRole("navigation", { name: "Breadcrumb" }).getByRole("button", { name: "Pick", exact: true }).click();
    await settled(page);
    await page.keyboard.press("Escape");
  });
});

describe("zoom", () => {
  it("goes in and out by key, and shows all with Ctrl+0", async () => {
    const fitted = await shownWidth();
    await page.keyboard.press("Control++");
    await expect.poll(shownWidth).toBeGreaterThan(fitted * 1.1);
    const larger = await shownWidth();
    await page.keyboard.press("Control+-");
    await page.keyboard.press("Control+-");
    await expect.poll(shownWidth).toBeLessThan(larger / 1.1);
    await expect.poll(() => shownWidth()).toBeLessThan(fitted);
    await page.keyboard.press("Control+0");
    await expect.poll(shownWidth).toBeCloseTo(fitted, 0);
  });

  it("prevents the browser's own zoom, and leaves other keys to the browser", async () => {
    await page.evaluate(() => {
      const taken: Record<string, boolean> = {};
      addEventListener("keydown", (event) => Object.assign(taken, { [event.key]: event.defaultPrevented }));
      Object.assign(window, { taken });
    });
    for (const key of ["Control++", "Control+-", "Control+0", "Control+c"]) await page.keyboard.press(key);
    expect(await page.evaluate((): unknown => Reflect.get(window, "taken"))).toMatchObject({ "+": true, "-": true, "0": true, c: false });
  });
});
