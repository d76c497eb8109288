// What a newcomer meets: an empty page with tasks to start, and the way to a phone.
import type { Page } from "playwright-core";
import { findings } from "./axe";
import { readCode } from "./qrCode";
import { openFixture, settled, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
  fixture.page.setDefaultTimeout(kPatience);
  await fixture.page.emulateMedia({ reducedMotion: "reduce" });
});
afterAll(() => fixture.close());

const card = (name: string) => fixture.page.getByRole("list", { name: "Tasks" }).getByRole("listitem", { name, exact: true });
const watched = () => fixture.page.getByRole("combobox", { name: "Watched run" });

describe("the page without a run", () => {
  it("offers the tasks of the server with their pictures, and finds nothing inaccessible in that", async () => {
    const { page } = fixture;
    await fixture.send("PUT", "/documents/waiting", { rcm: 1, name: "waiting", root: { state: "Root", doc: "Waits for an hour.", entry: "svc.timer.start(3600)", children: [{ state: "Inside" }] } });
    await page.goto(`${fixture.url}/pro/`);
    for (const name of ["pick", "waiting", "demonstrator"]) await card(name).getByRole("img", { name: `The states of ${name}` }).waitFor();
    expect(await card("waiting").innerText()).toContain("Waits for an hour.");
    expect(await card("waiting").locator("svg").textContent()).toContain("Inside");
    for (const colorScheme of ["light", "dark"] as const) {
      await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
      expect(await findings(page)).toEqual([]);
      await fixture.screenshot(`start-${colorScheme}`);
    }
    await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
  });

  it("shows how a phone reaches a display, as a link and as a code that a reader reads", async () => {
    const { page } = fixture;
    await page.getByRole("button", { name: "Show the code" }).click();
    const dialog = page.getByRole("dialog", { name: "Pair a phone" });
    await dialog.getByLabel("Name of the display").fill("left-hand");
    const address = `http://localhost:${new URL(fixture.url).port}/display/?name=left-hand`;
    await dialog.getByRole("link", { name: address }).waitFor();
    expect(await dialog.getByRole("list", { name: "What to do with the phone" }).innerText()).toContain("Another device needs the network");
    expect(await dialog.getByText("race serve --lan").isVisible()).toBe(false);
    await dialog.getByText("Details", { exact: true }).click();
    expect(await dialog.getByText("race serve --lan").isVisible()).toBe(true);
    expect(await readCode(page, await dialog.getByRole("img", { name: `QR code of ${address}` }).screenshot())).toBe(address);
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("pairing");
    await dialog.getByLabel("Name of the display").fill("all");
    await dialog.getByRole("alert").waitFor();
    await expect.poll(() => dialog.getByRole("link").count(), kSoon).toBe(0);
    await page.keyboard.press("Escape");
    await dialog.waitFor({ state: "detached" });
    await page.getByRole("tab", { name: "Services" }).click();
    await page.getByRole("button", { name: "Pair a phone" }).click();
    await dialog.waitFor();
    await page.keyboard.press("Escape");
    await page.getByRole("tab", { name: "Task" }).click();
  });

  it("starts a task by its card, and opens one in the editor", async () => {
    const { page } = fixture;
    await card("waiting").getByRole("button", { name: "Start" }).click();
    await expect.poll(() => page.getByRole("status", { name: "Run status" }).innerText(), kSoon).toContain("Running");
    await settled(page);
    await expect.poll(() => page.getByRole("region", { name: "Start" }).count(), kSoon).toBe(0);
    const id = await watched().inputValue();
    await fixture.send("POST", `/cores/${id}/stop`);
    await page.goto("about:blank"); // it may still ask for steps of the core
    await fixture.send("DELETE", `/cores/${id}`);
    await page.goto(`${fixture.url}/pro/`);
    await card("waiting").getByRole("button", { name: "Open" }).click();
    await expect.poll(() => new URL(page.url()).searchParams.get("edit"), kSoon).toBe("waiting");
  });

  it.each([
    ["a card of the expert page", "/pro/", (on: Page) => on.getByRole("list", { name: "Tasks" }).getByRole("listitem", { name: "waiting", exact: true }).getByRole("button", { name: "Start" })],
    ["RACE-One", "/one/?edit=waiting#run", (on: Page) => on.getByRole("button", { name: "Start", exact: true })],
    ["a phone", "/display/?name=phone1#run", (on: Page) => on.getByRole("button", { name: "Start waiting" })],
  ] as const)("makes one run by a double click in %s, of a server that is fast or late", async (_name, path, startOf) => {
    const page = await (await fixture.openContext({ viewport: { width: 1366, height: 768 }, reducedMotion: "reduce" })).newPage();
    page.setDefaultTimeout(kPatience);
    const runs = async () => ((await fixture.send("GET", "/cores")) as { readonly cores: readonly { readonly id: string; readonly status: string; readonly paused: boolean }[] }).cores;
    for (const late of [0, 700]) {
      await page.unrouteAll({ behavior: "wait" });
      await page.route("**/api/v1/cores", async (route) => {
        await new Promise((resolve) => setTimeout(resolve, late));
        await route.continue();
      });
      await page.goto(`${fixture.url}${path}`);
      const start = startOf(page);
      await start.waitFor();
      await expect.poll(() => start.isEnabled(), kSoon).toBe(true);
      const box = await start.boundingBox();
      if (box === null) throw new Error("there is no button");
      await page.mouse.dblclick(box.x + box.width / 2, box.y + box.height / 2, { delay: 40 });
      await expect.poll(async () => (await runs()).map(({ status }) => status), kSoon).toEqual(["running"]);
      await page.waitForTimeout(late + 1500);
      const all = await runs();
      // The second click did not press what came in the place of the button, either.
      expect(all.map(({ status, paused }) => [status, paused])).toEqual([["running", false]]);
      for (const { id } of all) await fixture.send("POST", `/cores/${id}/stop`);
      await page.goto("about:blank"); // before there is nothing that it could still ask for
      for (const { id } of all) await fixture.send("DELETE", `/cores/${id}`);
    }
    await page.context().close();
  });
});
