// Texts of code on the page that edits a document, on the real server: what is offered, explained and underlined.
import type { Page } from "playwright-core";
import { findings } from "./axe";
import { offered, write } from "./editPage";
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
    actions: [{ when: "True", do: "x = par.width" }, { when: "True", do: "pass" }],
    children: [{ state: "A", entry: "svc.gripper.stop()", ports: [{ name: "done", when: "svc.gripper.stop.result", to: "B" }] }, { state: "B" }, { state: "C", link: "Grasp" }],
  },
  library: [{ state: "Grasp", entry: "x = 1\nsvc.gripper.grasp(0.02)", ports: [{ name: "held", when: "True" }] }],
};
const entry = (page: Page) => page.getByRole("textbox", { name: "Entry" });
const option = (page: Page, name: string) => page.locator(".cm-tooltip-autocomplete li").filter({ hasText: new RegExp(`^${name}`) });

describe("a text whose editor comes late", () => {
  it("stays the plain field under the hand that writes in it", async () => {
    const { page, url, send } = fixture;
    await send("PUT", "/documents/late", kTask);
    let release = (): void => undefined;
    const released = new Promise<void>((resolve) => (release = resolve));
    await page.route("**/CodeEditor-*.js", async (route) => {
      await released;
      await route.continue();
    });
    await page.goto(`${url}/pro/?edit=late`);
    await settled(page);
    await page.locator('.react-flow [data-path="Root/B"]').click({ position: { x: 20, y: 8 } });
    await entry(page).click();
    await page.keyboard.type("x = 1");
    release();
    await page.locator('.code-editor [aria-label="Exit"]').waitFor();
    await page.keyboard.type("2");
    expect(await entry(page).evaluate((field) => [field.tagName, field === document.activeElement])).toEqual(["TEXTAREA", true]);
    await page.keyboard.press("Control+Enter");
    await expect.poll(async () => JSON.stringify(await send("GET", "/documents/late"))).toContain("x = 12");
    await page.keyboard.press("Tab");
    await page.locator('.code-editor [aria-label="Entry"]').waitFor();
    await page.unroute("**/CodeEditor-*.js");
  });
});

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
    expect(await findings(page)).toEqual([]);
    await page.keyboard.type("gras");
    await offered(page, "grasp");
    await page.keyboard.press("Enter");
    await page.keyboard.type("par.width");
    await expect.poll(() => entry(page).innerText()).toBe("svc.gripper.grasp(par.width)");
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
    await expect.poll(() => page.locator(".cm-lintRange-error").allInnerTexts()).toEqual(["done", "widht"]);
    await screenshot("code-mistakes");
  });

  it("underlines what the server finds, where it is", async () => {
    const { page } = fixture;
    await write(entry(page), "x = 1\ny = (x +");
    await page.keyboard.press("Control+Enter");
    await expect.poll(() => page.locator(".field-error").filter({ hasText: "never closed" }).count()).toBe(1);
    await page.locator(".cm-lintRange-error").first().waitFor();
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
    await expect.poll(() => entry(page).innerText()).toContain("y = (x +");
    await page.keyboard.press("Tab");
    expect(await entry(page).evaluate((element) => element === document.activeElement)).toBe(false);
  });
});

describe("operations that no service can accept", () => {
  const marked = (page: Page) => page.locator(".cm-tooltip-autocomplete li.is-unreachable");

  it("are struck through and last, with the reason, until a call makes them possible", async () => {
    const { page, screenshot } = fixture;
    await write(entry(page), "svc.timer.");
    await marked(page).first().waitFor();
    await screenshot("code-unreachable");
    await expect.poll(() => marked(page).allInnerTexts()).toEqual([expect.stringMatching(/^cancel\s*timer can only be in `Idle` here; cancel is accepted in `Running`$/)]);
    expect(await page.locator(".cm-tooltip-autocomplete li").last().getAttribute("class")).toContain("is-unreachable");
    expect(await marked(page).locator(".cm-completionLabel").evaluate((element) => getComputedStyle(element).textDecorationLine)).toBe("line-through");
    // A list of completions belongs to its field, wherever it is in the page.
    expect((await findings(page)).filter((finding) => !finding.startsWith("region:"))).toEqual([]);
    await page.keyboard.press("Escape");
    await write(entry(page), "svc.timer.start(1)\nsvc.timer.");
    await option(page, "cancel").waitFor();
    await expect.poll(() => marked(page).count()).toBe(0);
    await page.keyboard.press("Escape");
    await page.keyboard.press("Escape");
  });
});

describe("Enter, with a completion open", () => {
  const condition = (page: Page) => page.getByRole("textbox", { name: "Condition" }).first();
  const stored = async () => ((await fixture.send("GET", "/documents/code")) as { document: { root: { actions: { when: string }[] } } }).document.root.actions[0]?.when;

  it("takes what changes the text, and else commits it", async () => {
    const { page } = fixture;
    await write(condition(page), "Fals");
    await offered(page, "False");
    await page.keyboard.press("Enter");
    await expect.poll(() => condition(page).innerText()).toBe("False");
    expect(await stored()).toBe("True");
    await write(condition(page), "");
    await page.keyboard.type("False");
    await offered(page, "False");
    await page.keyboard.press("Enter");
    await expect.poll(stored).toBe("False");
  });
});

describe("the tip over a text of a row", () => {
  it("covers no handle of its row, and leaves when the row is dragged", async () => {
    const { page, screenshot } = fixture;
    const tip = page.locator(".code-hover");
    const row = page.locator("[data-row]").filter({ has: page.getByRole("textbox", { name: "Function" }) }).first();
    await row.locator(".cm-line").filter({ hasText: "par.width" }).getByText("par", { exact: true }).hover();
    await tip.waitFor();
    await screenshot("code-hover-row");
    // It gets its place after its text.
    await expect.poll(async () => {
      const [over, handle] = [await tip.boundingBox(), await row.locator(".row-handle").boundingBox()];
      return (over?.x ?? 0) - (handle?.x ?? 0) - (handle?.width ?? 0);
    }).toBeGreaterThanOrEqual(0);
    // As a hand does that is quicker than the tip: it is there when the row is pressed.
    await row.locator(".row-handle").dispatchEvent("pointerdown", { button: 0, pointerId: 1 });
    await tip.waitFor({ state: "detached" });
    await page.mouse.move(5, 5);
  });
});

describe("usages", () => {
  const list = (page: Page) => page.getByRole("region", { name: /^Usages of/ });
  const lines = (page: Page) => list(page).getByRole("listitem").allInnerTexts();
  const focused = (page: Page) => page.evaluate(() => document.activeElement?.getAttribute("aria-label"));

  it("of the name under the cursor lead to where they are, in the library too", async () => {
    const { page, screenshot } = fixture;
    await settled(page);
    await page.locator('.react-flow [data-path="Root/A"]').click({ position: { x: 20, y: 8 } });
    await entry(page).filter({ hasText: "svc.gripper.stop" }).click();
    await page.keyboard.press("Home");
    for (const key of Array<string>("svc.grip".length).fill("ArrowRight")) await page.keyboard.press(key);
    await page.keyboard.press("Shift+F12");
    await list(page).waitFor();
    await expect.poll(() => list(page).getAttribute("aria-label")).toBe("Usages of service gripper");
    await expect.poll(() => lines(page)).toEqual([expect.stringMatching(/Root\/A, entry\s+svc\.gripper\.stop\(\)/), expect.stringMatching(/Root\/A\.done, condition\s+svc/), expect.stringMatching(/library\/Grasp, entry\s+svc\.gripper\.grasp/)]);
    await screenshot("usages");
    expect(await findings(page)).toEqual([]);
    await page.keyboard.press("End");
    await page.keyboard.press("Enter");
    await page.getByRole("navigation", { name: "Library state" }).filter({ hasText: "Grasp" }).waitFor();
    await expect.poll(() => focused(page)).toBe("Entry");
    await expect.poll(() => page.evaluate(() => getSelection()?.toString())).toBe("gripper");
    await screenshot("usages-library");
  });

  it("are found by the menu, too; where there are none, it is said, and Esc closes the list", async () => {
    const { page } = fixture;
    await settled(page);
    await page.getByRole("button", { name: "← Root" }).click();
    await settled(page);
    await page.locator('.react-flow [data-path="Root/B"]').click({ position: { x: 20, y: 8 }, button: "right" });
    await page.getByRole("menuitem", { name: /^Find usages/ }).click();
    await expect.poll(() => list(page).getAttribute("aria-label")).toBe("Usages of state Root/B");
    await list(page).getByRole("button", { name: /Root\/A\.done, target/ }).click();
    await expect.poll(() => page.getByRole("combobox", { name: "Leads to" }).evaluate((field) => field === document.activeElement)).toBe(true);
    await settled(page);
    await page.locator('.react-flow [data-path="Root/C"]').click({ position: { x: 20, y: 8 } });
    await page.keyboard.press("Shift+F12");
    await list(page).filter({ hasText: "Nothing in the document names it." }).waitFor();
    await page.keyboard.press("Escape");
    await list(page).waitFor({ state: "detached" });
    await expect.poll(() => focused(page)).toMatch(/^Drawing of/);
  });
});

describe("F2 in a text", () => {
  it("renames what the name under the cursor stands for, wherever it is named, with what was not sent yet", async () => {
    const { page, send, screenshot } = fixture;
    const root = async () => ((await send("GET", "/documents/code")) as { document: { root: { parameters: { name: string }[]; actions: { do: string }[] } } }).document.root;
    await settled(page);
    await page.locator('.react-flow [data-path="Root"]').click({ position: { x: 20, y: 8 } });
    const text = page.getByRole("textbox", { name: "Function" }).first();
    await write(text, "x = 2 * par.width");
    await page.keyboard.press("F2");
    const name = page.getByRole("textbox", { name: "Name of width" });
    await name.waitFor();
    await screenshot("code-rename");
    await page.keyboard.type("breadth");
    await page.keyboard.press("Enter");
    await expect.poll(async () => [(await root()).parameters[0]?.name, (await root()).actions[0]?.do]).toEqual(["breadth", "x = 2 * par.breadth"]);
    await expect.poll(() => text.innerText()).toBe("x = 2 * par.breadth");
    await expect.poll(() => text.evaluate((field) => field === document.activeElement)).toBe(true);
    // Completions that are still computed open nothing over the field that asks.
    await write(text, "x = par.bread");
    await page.keyboard.type("th");
    await page.keyboard.press("F2");
    await page.getByRole("textbox", { name: "Name of breadth" }).waitFor();
    await page.waitForTimeout(600);
    expect(await page.locator(".cm-tooltip-autocomplete").count()).toBe(0);
    await page.keyboard.press("Escape");
    await write(text, "x = 2");
    await page.keyboard.press("F2");
    await page.getByRole("log", { name: "Refused edits" }).getByText("no name of the document is under the cursor").waitFor();
  });
});
