// The light and the dark theme: chosen by a button, kept, or as the system has it.
import type { Page } from "playwright-core";
import { openFixture, settled, type Fixture } from "./fixture";
import { letMove } from "./hands";
import { reachNode, showStep } from "./proofText";

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
});
afterAll(() => fixture.close());

const shown = async (of = page): Promise<"light" | "dark"> => {
  const [red = 0] = /\d+/.exec(await of.locator("body").evaluate((body) => getComputedStyle(body).backgroundColor))?.map(Number) ?? [];
  return red > 127 ? "light" : "dark";
};
const button = (of = page) => of.getByRole("button", { name: /^Theme:/ });
const open = async () => {
  await page.goto(`${fixture.url}/pro/`);
  await page.getByText("Connected").waitFor();
};

describe("the theme", () => {
  it("follows the system at first, and while the page is open", async () => {
    await page.emulateMedia({ colorScheme: "dark" });
    await open();
    await expect.poll(() => shown()).toBe("dark");
    const frame = () => page.locator("meta[name=theme-color]").getAttribute("content");
    const dark = await frame();
    await page.emulateMedia({ colorScheme: "light" });
    await expect.poll(() => shown()).toBe("light");
    await expect.poll(frame).not.toBe(dark);
  });

  it("is chosen by key, and survives a reload on a system that prefers the other", async () => {
    await button().focus();
    await page.keyboard.press("Enter");
    await button().and(page.getByRole("button", { name: "Theme: light" })).waitFor();
    await page.keyboard.press("Enter");
    await page.getByRole("button", { name: "Theme: dark" }).waitFor();
    await expect.poll(() => shown()).toBe("dark");
    await page.reload();
    await page.getByText("Connected").waitFor();
    await expect.poll(() => shown()).toBe("dark");
    await expect.poll(() => button().getAttribute("aria-label")).toBe("Theme: dark");
  });

  it("is set before the body of the page exists, so that no other theme flashes", async () => {
    await page.addInitScript(() => {
      new MutationObserver((_, observer) => {
        if (!document.contains(document.body)) return;
        observer.disconnect();
        document.body.dataset["themeAtFirst"] = document.documentElement.dataset["theme"];
      }).observe(document, { childList: true, subtree: true });
    });
    await page.reload();
    expect(await page.locator("body").getAttribute("data-theme-at-first")).toBe("dark");
  });

  it("is left to the system again by the same button", async () => {
    await button().click();
    await page.getByRole("button", { name: "Theme: system" }).waitFor();
    await expect.poll(() => shown()).toBe("light");
    await page.reload();
    await page.getByText("Connected").waitFor();
    await expect.poll(() => shown()).toBe("light");
  });
});

const kSizes = [
  { width: 1366, height: 768 },
  { width: 1600, height: 1000 },
  { width: 2560, height: 1440 },
] as const;

describe("screenshots", () => {
  it("show every page in both themes", async () => {
    await letMove(page, "pick");
    await page.getByRole("combobox", { name: "Document" }).selectOption("pick");
    await page.getByRole("button", { name: "Load" }).click();
    await page.getByRole("group", { name: "State Pick/Release" }).waitFor();
    for (const name of ["active", "ended", "derivation", "services", "cell", "edit"] as const) {
      await turnTo(name);
      for (const size of kSizes)
        for (const colorScheme of ["light", "dark"] as const) {
          await page.setViewportSize(size);
          await page.emulateMedia({ colorScheme });
          await page.waitForTimeout(400);
          await fixture.screenshot(`theme-${name}-${size.width}-${colorScheme}`);
        }
    }
  });
});

async function turnTo(name: "active" | "ended" | "derivation" | "services" | "cell" | "edit"): Promise<void> {
  switch (name) {
    case "active":
      await page.getByRole("button", { name: "Macro step" }).click();
      return page.locator(".state.is-active").nth(1).waitFor();
    case "ended":
      await page.getByRole("button", { name: "Resume" }).click();
      return expect.poll(() => page.getByRole("status", { name: "Run status" }).innerText(), { timeout: 90_000 }).toContain("Ended");
    case "derivation":
      await showStep(page, 1);
      return (await reachNode(page, /^PTrans1/)).locator(".proof-row").first().click();
    case "services":
    case "cell":
      return page.getByRole("tab", { name: name === "cell" ? "Cell" : "Services" }).click();
    case "edit":
      await page.goto(`${fixture.url}/pro/?edit=pick`);
      return settled(page);
  }
}
