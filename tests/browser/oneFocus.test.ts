// Where the focus is on the novice page, the page of a phone and the expert page while dialogs, sheets and steps come and go: never nowhere.
import { devices, type Locator, type Page } from "playwright-core";
import { openFixture, type Fixture } from "./fixture";
import { kPatience } from "./patience";

let fixture: Fixture;
let page: Page;
beforeAll(async () => {
  fixture = await openFixture();
  ({ page } = fixture);
  page.setDefaultTimeout(kPatience);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.setViewportSize({ width: 1366, height: 768 });
});
afterAll(() => fixture.close());

/** Tag and name of what has the focus. */
const focus = (on: Page) =>
  on.evaluate(() => {
    const at = document.activeElement;
    return at === null || at === document.body ? "nothing" : `${at.tagName.toLowerCase()} ${at.getAttribute("aria-label") ?? at.textContent.trim().slice(0, 40)}`;
  });
const has = (locator: Locator) => expect.poll(() => locator.evaluate((element) => element === document.activeElement)).toBe(true);

const kClosing: Readonly<Record<string, (dialog: Locator, on: Page) => Promise<void>>> = {
  "Escape": (_, on) => on.keyboard.press("Escape"),
  "its cross": (dialog) => dialog.getByRole("button", { name: "Close" }).click(),
  "a press beside it": (_, on) => on.mouse.click(4, 300),
};

const kOpeners = [
  ["RACE-One", "/one/", "Pair a phone", "Pair a phone", "input"],
  ["the expert page", "/pro/", "Show the code", "Pair a phone", "input"],
  ["the expert page", "/pro/", "Keys and mouse", "Keys and mouse", "h2"],
] as const;

describe.each(kOpeners)("a dialog of %s (%s, %s)", (_page, path, opener, name, first) => {
  it.each(Object.keys(kClosing))("begins at its first field or heading, and gives the focus back by %s", async (way) => {
    await page.goto(`${fixture.url}${path}`);
    const button = page.getByRole("button", { name: opener }).first();
    await button.click();
    const dialog = page.getByRole("dialog", { name });
    await dialog.waitFor();
    await has(dialog.locator(first).first());
    // Beside what can be pressed, so that nothing in it has the focus.
    await dialog.locator("h2").first().click();
    await kClosing[way]?.(dialog, page);
    await dialog.waitFor({ state: "detached" });
    await has(button);
  });
});

describe("the reset of the stop", () => {
  it.each(["/one/", "/display/?name=phone1", "/pro/"])("gives the focus back on %s, and leaves it on the page when the banner is gone", async (path) => {
    await page.goto(`${fixture.url}${path}`);
    await fixture.send("POST", "/stop");
    const reset = page.getByRole("button", { name: "Reset…" });
    await reset.click();
    const dialog = page.getByRole("dialog", { name: "Reset the stop?" });
    await has(dialog.getByRole("button", { name: "Keep it stopped" }));
    await page.keyboard.press("Escape");
    await dialog.waitFor({ state: "detached" });
    await has(reset);
    await reset.press("Enter");
    await dialog.getByRole("button", { name: "Nobody is there: reset" }).click();
    await reset.waitFor({ state: "detached" });
    await expect.poll(() => focus(page)).not.toBe("nothing");
  });
});

describe("the guide", () => {
  it("leads to the heading of each step, and of what is shown after it", async () => {
    await page.goto(`${fixture.url}/one/`);
    await page.getByRole("button", { name: "Show me how" }).press("Enter");
    await expect.poll(() => focus(page)).toMatch(/^h1 /);
    await page.getByRole("region", { name: /guide/i }).getByRole("button").first().press("Enter");
    await has(page.getByRole("heading", { name: "What shall the robot do?" }));
  });
});

describe("what lies over the tasks on a phone", () => {
  let phone: Page;
  beforeAll(async () => {
    phone = await (await fixture.openContext({ ...devices["Pixel 7"], reducedMotion: "reduce" })).newPage();
    phone.setDefaultTimeout(kPatience);
    await phone.goto(`${fixture.url}/one/`);
    await phone.getByLabel("A new application").fill("focus");
    await phone.getByRole("button", { name: "Begin" }).click();
    await phone.getByLabel("Name of the task").fill("First");
    await phone.getByRole("button", { name: "Add the task" }).click();
    await phone.getByRole("region", { name: "Task First" }).waitFor();
  });
  afterAll(() => phone.context().close());

  const library = () => phone.getByRole("complementary", { name: "Skills" });
  const panel = () => phone.getByRole("complementary", { name: "What is selected" });

  it("has the focus when it is opened, and gives it back to what opened it", async () => {
    await has(library());
    await phone.keyboard.press("Escape");
    await library().waitFor({ state: "hidden" });
    await expect.poll(() => focus(phone)).not.toBe("nothing");
    const add = phone.locator(".add-step button");
    for (const close of [() => phone.keyboard.press("Escape"), () => library().locator(".sheet-close").click()]) {
      await add.click();
      await library().waitFor();
      await close();
      await library().waitFor({ state: "hidden" });
      await has(add);
    }
    const card = phone.locator(".card-open").first();
    for (const close of [() => phone.keyboard.press("Escape"), () => panel().locator(".sheet-close").click()]) {
      await card.click();
      await has(panel());
      await close();
      await panel().waitFor({ state: "hidden" });
      await has(card);
    }
  });

  it("gives the focus back to the button of a new task that is given up", async () => {
    for (const close of [() => phone.keyboard.press("Escape"), () => phone.getByRole("button", { name: "Cancel" }).click()]) {
      await phone.getByRole("button", { name: "+ Add a task" }).click();
      await has(phone.getByLabel("Name of the task"));
      await close();
      await has(phone.getByRole("button", { name: "+ Add a task" }));
    }
  });
});
