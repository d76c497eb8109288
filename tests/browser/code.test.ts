// Texts of code on the page that edits a document, on the real server: what is offered, explained and underlined.
import type { Page } from "playwright-core";
import { write } from "./editPage";
import { openFixture, settled, type Fixture } from "./fixture";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
});
afterAll(() => fixture.close());

const kTask = {
  rcm: 1,
  root: {
    state: "Root", first: "A", parameters: [{ name: "width", value: 0.05, type: "number", unit: "m", doc: "Of the object" }],
    children: [{ state: "A", entry: "svc.gripper.stop()", ports: [{ name: "done", when: "svc.gripper.stop.result", to: "B" }] }, { state: "B" }],
  },
};
const entry = (page: Page) => page.getByRole("textbox", { name: "Entry" });
const option = (page: Page, name: string) => page.locator(".cm-tooltip-autocomplete li").filter({ hasText: new RegExp(`^${name}`) });

describe("a text of code", () => {
  beforeAll(async () => {
    const { page, url, send } = fixture;
    await send("PUT", "/documents/code", kTask);
    await page.goto(`${url}/pro/?edit=code`);
    await settled(page);
    await page.locator('.react-flow [data-path="Root"]').click({ position: { x: 20, y: 8 } });
    await page.locator('.code-editor [aria-label="Entry"]').waitFor();
  });

  it("offers the operations of a service, which are chosen by keys", async () => {
    const { page, screenshot } = fixture;
    await entry(page).click();
    await page.keyboard.type("svc.gripper.");
    await option(page, "grasp").waitFor();
    await screenshot("code-completion");
    await page.keyboard.type("gras");
    await page.keyboard.press("Enter");
    await page.keyboard.type("par.width");
    expect(await entry(page).innerText()).toBe("svc.gripper.grasp(par.width)");
  });

  it("says what a name is, with its unit", async () => {
    const { page, screenshot } = fixture;
    await page.keyboard.press("Escape");
    await page.locator(".code-editor .cm-line").filter({ hasText: "par.width" }).getByText("par", { exact: true }).first().hover();
    await page.locator(".code-hover").filter({ hasText: "Parameters of the state" }).waitFor();
    await screenshot("code-hover");
  });

  it("underlines a name that means nothing, before it is sent", async () => {
    const { page, screenshot } = fixture;
    await write(entry(page), "res.done = par.widht");
    await page.locator(".cm-lintRange-error").first().waitFor({ timeout: 1000 });
    expect(await page.locator(".cm-lintRange-error").allInnerTexts()).toEqual(["done", "widht"]);
    await screenshot("code-mistakes");
  });

  it("underlines what the server finds, where it is", async () => {
    const { page } = fixture;
    await write(entry(page), "x = 1\ny = (x +");
    await page.keyboard.press("Control+Enter");
    await page.locator(".cm-lintRange-error").first().waitFor({ timeout: 3000 });
    expect(await page.locator(".field-error").filter({ hasText: "never closed" }).count()).toBe(1);
  });

  it("is given up by Esc, which closes what is offered before, and left by Tab", async () => {
    const { page } = fixture;
    const offers = page.locator(".cm-tooltip-autocomplete");
    await write(entry(page), "");
    await page.keyboard.type("pas");
    await offers.waitFor();
    await page.keyboard.press("Escape");
    await offers.waitFor({ state: "detached" });
    expect(await entry(page).innerText()).toBe("pas");
    await page.keyboard.press("Escape");
    expect(await entry(page).innerText()).toContain("y = (x +");
    await page.keyboard.press("Tab");
    expect(await entry(page).evaluate((element) => element === document.activeElement)).toBe(false);
  });
});
