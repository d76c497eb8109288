// The time line of a run: bars of states and calls, a plot, values as a file; a click goes to that macro step. Two runs are compared.
import type { Page } from "playwright-core";
import { findings } from "./axe";
import { openFixture, settled, textOf, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
  page.setDefaultTimeout(kPatience);
  await page.setViewportSize({ width: 1366, height: 768 });
});
afterAll(() => fixture.close());

const soon = (value: () => unknown) => expect.poll(value, kSoon);
const moment = () => new URL(page.url()).searchParams.get("at");

/** Counts to `last`, a wait for each, and ends. */
const counting = {
  state: "Root", first: "Wait", parameters: [{ name: "last", value: 3 }], results: [{ name: "n" }], entry: "res.n = 0",
  children: [
    { state: "Wait", entry: "svc.timer.wait(0.03)", ports: [{ name: "done", when: "svc.timer.wait.result", to: "Count" }] },
    { state: "Count", ports: [{ name: "again", when: "True", to: "Wait" }] },
  ],
  actions: [{ when: "chi.Wait.port.done", do: "res.n = res.n + 1" }],
  ports: [{ name: "done", when: "available(res.n) and res.n >= par.last" }],
};

async function count(last: number): Promise<string> {
  const { id } = (await fixture.send("POST", "/cores", { document: "counting", arguments: { last } })) as { readonly id: string };
  await fixture.send("POST", `/cores/${id}/start`);
  await soon(async () => ((await fixture.send("GET", `/cores/${id}`)) as { readonly status: string }).status).toBe("ended");
  return id;
}

describe("the time line", () => {
  let short: string;
  let long: string;

  it("is there while the run goes on faster than the server answers", async () => {
    await fixture.send("PUT", "/documents/counting", { rcm: 1, name: "counting", root: counting });
    const { id } = (await fixture.send("POST", "/cores", { document: "counting", arguments: { last: 100_000 } })) as { readonly id: string };
    await fixture.send("POST", `/cores/${id}/start`);
    const slow = /\/derivations/;
    await page.route(slow, async (route) => {
      await new Promise((resolve) => setTimeout(resolve, 400));
      await route.continue();
    });
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(page);
    await page.getByRole("tab", { name: "Time line" }).click();
    await page.getByRole("heading", { name: /^Macro steps 1 to \d+$/ }).waitFor();
    await fixture.send("POST", `/cores/${id}/stop`);
    await page.unrouteAll({ behavior: "wait" });
  });

  it("has a bar for each state and call, and plots a number", async () => {
    short = await count(2);
    long = await count(4);
    await page.goto(`${fixture.url}/pro/?run=${long}`);
    await settled(page);
    await page.getByRole("tab", { name: "Time line" }).click();
    const states = page.getByRole("list", { name: "States over time" });
    await soon(() => states.getByRole("button").allInnerTexts()).toEqual(["Root", "Wait"]);
    await soon(() => states.getByRole("img").nth(1).getAttribute("aria-label")).toMatch(/^Root\/Wait: active from step 1 to 5 \(\d+\.\d+ s\)/);
    const calls = page.getByRole("list", { name: "Calls over time" });
    const shown = () => calls.getByRole("button").allInnerTexts();
    await soon(async () => (await shown()).map((text) => text.split(/\s+/)[0])).toEqual(Array(4).fill("timer.wait(0.03)"));
    const rows = await shown();
    for (const seconds of rows.map((text) => Number.parseFloat(text.split(/\s+/)[1] ?? ""))) {
      // The timer counts the time of its group, which on a busy machine catches up with the clock in steps of some milliseconds.
      expect(seconds).toBeGreaterThanOrEqual(0.02);
      expect(seconds).toBeLessThan(5);
    }
    const plot = page.getByRole("img", { name: "Root.res.n over time" });
    await soon(() => plot.locator("canvas").count()).toBe(1);
    await settled(page);
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("timeline");
    await page.emulateMedia({ colorScheme: "dark" });
    await soon(() => findings(page)).toEqual([]);
    await fixture.screenshot("timeline-dark");
    await page.emulateMedia({ colorScheme: "light" });
  });

  it("has the states of the services of the run", async () => {
    await fixture.send("PUT", "/documents/stored", { rcm: 1, name: "stored", root: { state: "Root", entry: "svc.db.put('a', 1)", ports: [{ name: "done", when: "svc.db.put.result or svc.db.put.error" }] } });
    const { id } = (await fixture.send("POST", "/cores", { document: "stored" })) as { readonly id: string };
    await fixture.send("POST", `/cores/${id}/start`);
    await soon(async () => ((await fixture.send("GET", `/cores/${id}`)) as { readonly status: string }).status).toBe("ended");
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(page);
    await page.getByRole("tab", { name: "Time line" }).click();
    const services = page.getByRole("list", { name: "States of services over time" });
    await soon(() => services.getByRole("button").allInnerTexts()).toEqual(["db"]);
    await soon(() => services.getByRole("img").getAttribute("aria-label")).toMatch(/^db: \w+ for \d/);
    await page.goto(`${fixture.url}/pro/?run=${long}`);
    await settled(page);
    await page.getByRole("tab", { name: "Time line" }).click();
  });

  it("counts seconds or macro steps, as the address says", async () => {
    const axis = page.getByRole("combobox", { name: "Axis" });
    await soon(() => axis.inputValue()).toBe("seconds");
    await axis.selectOption("macro steps");
    await page.getByRole("list", { name: "States over macro steps" }).waitFor();
    await soon(() => page.getByRole("list", { name: "States of services over time" }).getByRole("img").first().getAttribute("aria-label")).toMatch(/: \w+ for \d/);
    await soon(() => new URL(page.url()).searchParams.get("axis")).toBe("steps");
    await page.reload();
    await settled(page);
    await page.getByRole("img", { name: "Root.res.n over macro steps" }).waitFor();
    await fixture.screenshot("timeline-steps");
  });

  it("leads by a click to that macro step", async () => {
    const bar = page.getByRole("list", { name: "States over macro steps" }).getByRole("img").first();
    const box = await bar.boundingBox();
    const last = Number((await page.getByRole("heading", { name: /^Macro steps 1 to/ }).innerText()).split(" ").at(-1));
    await bar.click({ position: { x: ((box?.width ?? 0) * 1.5) / last, y: 5 } });
    await soon(moment).toMatch(/^2\./);
    await page.getByRole("list", { name: "Calls over macro steps" }).getByRole("button").first().click();
    await soon(moment).toMatch(/^1\./);
    const plot = page.getByRole("img", { name: "Root.res.n over macro steps" });
    const over = plot.locator(".u-over");
    const place = await over.boundingBox();
    await over.click({ position: { x: ((place?.width ?? 0) * 2.5) / last, y: 20 } });
    await soon(moment).toMatch(/^3\./);
  });

  it("leads there also by seconds", async () => {
    await page.getByRole("combobox", { name: "Axis" }).selectOption("seconds");
    const bar = page.getByRole("list", { name: "States over time" }).getByRole("img").first();
    await bar.waitFor();
    const box = await bar.boundingBox();
    await bar.click({ position: { x: 2, y: 5 } });
    await soon(moment).toMatch(/^1\./);
    await bar.click({ position: { x: (box?.width ?? 0) / 2, y: 5 } });
    await soon(() => moment() ?? "present").not.toMatch(/^1\./);
  });

  it("gives the values as a file", async () => {
    const [file] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Values as CSV" }).click()]);
    expect(file.suggestedFilename()).toBe(`run-${long}.csv`);
    const rows = (await textOf(file)).trim().split("\r\n").map((row) => row.split(","));
    const n = rows[0]?.indexOf("Root.res.n") ?? -1;
    expect(rows[0]?.slice(0, 3)).toEqual(["step", "input", "seconds"]);
    expect(rows.slice(1).every((row) => /^\d+(\.\d+)?$/.test(row[2] ?? ""))).toBe(true);
    expect(rows.slice(1).map((row) => row[n])).toEqual(expect.arrayContaining(["0", "1", "2", "3", "4"]));
  });

  it("leads from the list of runs to the first derivation that differs from another run", async () => {
    await page.getByRole("button", { name: "Runs", exact: true }).click();
    const row = page.getByRole("listitem", { name: `Run ${short}`, exact: true });
    await row.getByRole("button", { name: "Compare" }).click();
    const found = row.getByRole("group", { name: `Run ${long} and run ${short}` });
    await soon(() => found.getByRole("status").innerText()).toBe("They first differ in macro step 1, micro step 1.");
    await fixture.screenshot("runs-compared");
    await found.getByRole("button", { name: `Show in run ${short}` }).click();
    await soon(moment).toBe("1.0");
    await soon(() => new URL(page.url()).searchParams.get("run")).toBe(short);
    await page.getByRole("article", { name: "Micro step 1" }).waitFor();
  });
});
