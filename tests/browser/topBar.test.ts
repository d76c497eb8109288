// What stands above and below the drawing takes little room, hides nothing, and all of it can be reached.
import type { Locator } from "playwright-core";
import { findings } from "./axe";
import { openFixture, settled, type Fixture } from "./fixture";

let fixture: Fixture;
let id: string;
beforeAll(async () => {
  fixture = await openFixture();
  await fixture.send("PUT", "/documents/still", { rcm: 1, root: { state: "Root", first: "A", children: [{ state: "A" }], ports: [{ name: "never", when: "False" }] } });
  id = ((await fixture.send("POST", "/cores", { document: "still" })) as { readonly id: string }).id;
  await fixture.send("POST", `/cores/${id}/start`);
});
afterAll(() => fixture.close());

/** Whether a click in the middle of it would be a click on it. */
const isFree = (part: Locator) =>
  part.evaluate((element) => {
    element.scrollIntoView({ block: "nearest", inline: "nearest" });
    const { x, y, width, height } = element.getBoundingClientRect();
    const top = document.elementFromPoint(x + width / 2, y + height / 2);
    return top !== null && element.contains(top);
  });

it("the bar above has two rows on a phone, in both themes, and all that is in it is reached", async () => {
  const { page, url, screenshot } = fixture;
  await page.setViewportSize({ width: 390, height: 844 });
  await page.goto(`${url}/pro/?edit=demonstrator`);
  await settled(page);
  const bar = page.locator(".topbar");
  await expect.poll(async () => (await bar.boundingBox())?.height ?? 999).toBeLessThan(90);
  await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  const parts = await bar.locator("button, select").all();
  expect(parts.length).toBeGreaterThan(12);
  for (const part of parts) expect(await isFree(part), await part.innerText()).toBe(true);
  await screenshot("topbar-phone");
  await page.emulateMedia({ colorScheme: "dark" });
  await screenshot("topbar-phone-dark");
  expect(await findings(page)).toEqual([]);
  await page.emulateMedia({ colorScheme: "light" });
});

it.each([[1366, 768], [390, 844]])("an error covers nothing of the drawing and its tools in a window of %i x %i", async (width, height) => {
  const { page, url, allowError, screenshot } = fixture;
  allowError(/400 .*past\?step=999/);
  await page.setViewportSize({ width, height });
  await page.goto(`${url}/pro/?run=${id}&at=999.0`);
  const problem = page.locator(".problem");
  await problem.waitFor();
  await settled(page);
  await screenshot(`problem-${width}`);
  const tools = await page.locator(".canvas-tools button:visible, .zoom-controls button, .runbar button:enabled").all();
  expect(tools.length).toBeGreaterThan(6);
  for (const tool of tools) expect(await isFree(tool), await tool.innerText()).toBe(true);
  await problem.getByRole("button", { name: "Dismiss" }).click();
  expect(await problem.count()).toBe(0);
});
