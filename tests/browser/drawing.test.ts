// Drawings that fail, and long drawings that the user cancels. The test delays the workers of the page.
import type { Page } from "playwright-core";
import { openFixture, settled, textOf, type Fixture } from "./fixture";

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
  fixture.allowError(/\/there\/is\/none\.js/);
  await page.addInitScript(() => {
    const Real = Worker;
    const kept: (() => void)[] = [];
    let holding = false;
    window.Worker = class extends Real {
      constructor(url: string | URL) {
        super(sessionStorage.getItem("lost") === null ? url : "/there/is/none.js");
      }
      override postMessage(message: unknown): void {
        const send = () => super.postMessage(message);
        if (holding) kept.push(send);
        else send();
      }
    };
    Object.assign(window, {
      hold: (on: boolean) => {
        holding = on;
        if (!on) kept.splice(0).forEach((send) => send());
      },
    });
  });
});
afterAll(() => fixture.close());

const hold = (on: boolean) => page.evaluate((on) => {
    (Reflect.get(window, "hold") as (on: boolean) => void)(on);
  }, on);
const progress = () => page.getByRole("status", { name: "Drawing", exact: true });
const button = (name: string) => page.getByRole("button", { name, exact: true });
const state = (path: string) => page.getByRole("group", { name: `State ${path}`, exact: true });

async function load(document: string): Promise<void> {
  await page.getByRole("combobox", { name: "Document" }).selectOption(document);
  const runs = page.getByRole("combobox", { name: "Watched run" });
  const before = await runs.inputValue();
  await button("Load").click();
  // Only then the drawing of the previous run is removed.
  await expect.poll(() => runs.inputValue()).not.toBe(before);
}

describe("a drawing whose worker cannot be loaded", () => {
  it("is reported as failed, and not as in progress", async () => {
    await page.goto(`${fixture.url}/pro/`);
    await page.evaluate(() => sessionStorage.setItem("lost", ""));
    // Layouts of the demo come with the pages.
    await fixture.send("PUT", "/documents/new", { rcm: 1, name: "new", root: { state: "Root", children: [{ state: "A" }, { state: "B" }], first: "A" } });
    await page.reload();
    await load("new");
    await page.getByRole("alert").getByText("the layout does not start").waitFor();
    await page.getByText("The model could not be drawn.").waitFor();
    expect(await page.getByText("Drawing the model…").count()).toBe(0);
  });

  it("is made on a new request once the worker can be loaded", async () => {
    await page.evaluate(() => sessionStorage.clear());
    await button("Dismiss").click();
    await load("new");
    await state("Root/A").waitFor();
    expect(await page.getByRole("alert").count()).toBe(0);
  });
});

describe("a drawing as a file", () => {
  it("is an SVG image by itself, with all that is drawn", async () => {
    await load("pick");
    await settled(page);
    const saved = page.waitForEvent("download");
    await button("Save as SVG").click();
    const file = await saved;
    expect(file.suggestedFilename()).toBe("Pick.svg");
    const text = await textOf(file);
    const drawn = await page.locator(".canvas .state").count();
    const image = await page.evaluate((text) => {
      // Its style would be one of the page, which forbids such.
      const svg = new DOMParser().parseFromString(text.replace(/<style>[^<]*<\/style>/, ""), "image/svg+xml");
      return { faulty: svg.querySelector("parsererror") !== null, states: svg.querySelectorAll(".svg-state").length, width: svg.documentElement.getAttribute("width") };
    }, text);
    expect(image).toEqual({ faulty: false, states: drawn, width: expect.stringMatching(/^\d+/) as string });
    // The colours are in the file: nothing of the page is needed.
    expect(text).toContain("rgb(");
    expect(text).not.toContain("var(");
  });
});

describe("a drawing that takes long", () => {
  const leave = async (composite: string, how: () => Promise<void>) => {
    const inside = () => page.locator(`[data-path^="Demonstrator/${composite}/"].state`);
    await load("demonstrator");
    await state(`Demonstrator/${composite}`).waitFor();
    await settled(page);
    await hold(true);
    await button(`Expand Demonstrator/${composite}`).click();
    await progress().getByText("Drawing the model…").waitFor();
    expect(await page.locator(".canvas").getAttribute("aria-busy")).toBe("true");
    await how();
    await progress().waitFor({ state: "detached" });
    await hold(false);
    await settled(page);
    expect(await inside().count()).toBe(0);
    await button(`Expand Demonstrator/${composite}`).click();
    await inside().first().waitFor();
  };

  it("is cancelled by Esc; the previous drawing stays, and a new request succeeds", () => leave("Calibration", () => page.keyboard.press("Escape")));
  it("is cancelled by its button in the same way", () => leave("Table", () => progress().getByRole("button", { name: "Cancel" }).click()));
});
