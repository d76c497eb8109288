// Drawings that fail, and drawings that take so long that a person leaves them. The page's workers are held by the test.
import type { Page } from "playwright-core";
import { openStage, settled, type Stage } from "./stage";

let stage: Stage;
let page: Page;

beforeAll(async () => {
  stage = await openStage();
  page = stage.page;
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
afterAll(() => stage.close());

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
  // Only then the drawing of the run before is gone.
  await expect.poll(() => runs.inputValue()).not.toBe(before);
}

describe("a drawing whose worker does not come", () => {
  it("is said to have failed, and to be made no more", async () => {
    await page.goto(`${stage.url}/pro/`);
    await page.evaluate(() => sessionStorage.setItem("lost", ""));
    await load("pick");
    await page.getByRole("alert").getByText("the layout does not start").waitFor();
    await page.getByText("The model could not be drawn.").waitFor();
    expect(await page.getByText("Drawing the model…").count()).toBe(0);
  });

  it("is made when it is asked for again, and the worker comes", async () => {
    await page.evaluate(() => sessionStorage.clear());
    await button("Dismiss").click();
    await load("pick");
    await state("Pick/Release").waitFor();
    expect(await page.getByRole("alert").count()).toBe(0);
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

  it("is left with Esc; what was drawn stays, and it can be made after all", () => leave("Calibration", () => page.keyboard.press("Escape")));
  it("is left with its button just so", () => leave("Table", () => progress().getByRole("button", { name: "Cancel" }).click()));
});
