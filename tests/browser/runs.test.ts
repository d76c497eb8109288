// Stored runs: listed, searched, opened after a restart of the server and scrubbed, downloaded and dropped on another page, deleted.
import type { Page } from "playwright-core";
import { findings } from "./axe";
import { editPage } from "./editPage";
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

interface CoreJson {
  readonly id: string;
  readonly status: string;
  readonly step: number;
}
const send = async (method: string, path: string, body?: unknown) => (await fixture.send(method, path, body)) as CoreJson;

/** Makes a run and waits for its end. */
async function runToEnd(document: string): Promise<CoreJson> {
  const { id } = await send("POST", "/cores", { document });
  await send("POST", `/cores/${id}/start`);
  await expect.poll(async () => (await send("GET", `/cores/${id}`)).status, { timeout: 60_000 }).toMatch(/ended|faulted/);
  return send("GET", `/cores/${id}`);
}

const banner = () => page.getByRole("region", { name: "Past" });
const moment = () => new URL(page.url()).searchParams.get("at");
const digest = () => page.getByRole("region", { name: "Moment" }).locator("dd code").first().getAttribute("title");
const activeIn = (of: Page) => of.locator('[role="treeitem"][data-active="true"]').evaluateAll((all) => all.map((each) => each.getAttribute("data-path")).join(" "));
const list = () => page.getByRole("list", { name: "Stored runs" });
const status = () => page.getByRole("status", { name: "Run status" }).locator("strong").innerText();

/** What is active, once that does not change any more: the tree follows the moment at its pace. */
async function activeAtRest(): Promise<string> {
  let [before, now] = ["?", await activeIn(page)];
  while (before !== now) {
    await page.waitForTimeout(100);
    [before, now] = [now, await activeIn(page)];
  }
  return now;
}

/** What the page shows at macro step `step`. */
async function seenAt(step: number): Promise<object> {
  const slider = banner().getByRole("slider", { name: "Macro step" });
  await slider.fill(String(step));
  await soon(moment).toMatch(new RegExp(`^${step}\\.`));
  await soon(() => page.getByRole("heading", { level: 2, name: `Step ${moment() ?? ""}`, exact: true }).count()).toBe(1);
  const clock = page.locator(".cell-clock");
  await soon(() => clock.innerText()).toContain(`as it was in step ${step}, cell time`);
  return { moment: moment(), digest: await digest(), active: await activeAtRest(), cell: await clock.innerText() };
}

/** Drops the file of a run onto a page. */
const dropOnto = (of: Page, text: string): Promise<void> =>
  of.evaluate((content) => {
    const files = new DataTransfer();
    files.items.add(new File([content], "yesterday.json", { type: "application/json" }));
    const drop = { bubbles: true, cancelable: true, dataTransfer: files };
    document.body.dispatchEvent(new DragEvent("dragenter", drop));
    document.body.dispatchEvent(new DragEvent("drop", drop));
  }, text);

/** The digest of a run before macro step `step`, as a page shows it. */
async function digestAt(of: Page, url: string, id: string, step: number): Promise<string | null> {
  await of.goto(`${url}/pro/?run=${id}&at=${step}.0`);
  await of.getByRole("heading", { level: 2, name: `Step ${step}.0`, exact: true }).waitFor();
  return of.getByRole("region", { name: "Moment" }).locator("dd code").first().getAttribute("title");
}

describe("a run of yesterday", () => {
  let picked: CoreJson;
  const live: object[] = [];

  it("is looked at while its core is there", async () => {
    picked = await runToEnd("pick");
    await fixture.send("PUT", "/documents/failing", { rcm: 1, root: { state: "Root", entry: "var.n = 1 / 0", variables: [{ name: "n" }] } });
    await runToEnd("failing");
    await page.goto(`${fixture.url}/pro/?run=${picked.id}`);
    await settled(page);
    await soon(status).toBe("Ended: success");
    await page.locator(".cell-clock").waitFor();
    await page.keyboard.press("F9");
    await banner().waitFor();
    for (const step of [2, 4, picked.step - 1]) live.push(await seenAt(step));
    expect(new Set(live.map((each) => JSON.stringify(each))).size).toBe(3);
  });

  it("is in the list after a restart of the server, where a search finds it by outcome and words", async () => {
    await fixture.kill();
    await fixture.restart();
    expect(((await fixture.send("GET", "/cores")) as { readonly cores: readonly object[] }).cores).toEqual([]);
    await page.goto(`${fixture.url}/pro/`);
    await page.getByRole("button", { name: "Runs", exact: true }).click();
    await soon(() => list().getByRole("listitem").count()).toBe(2);
    await soon(() => page.evaluate(() => location.search)).toBe("?runs=1");
    await soon(() => list().getByRole("listitem").first().innerText()).toContain("failing");
    const found = page.getByRole("status", { name: "Found" });
    await page.getByRole("combobox", { name: "With the outcome" }).selectOption("bad");
    await soon(() => found.innerText()).toBe("1 of 2 runs");
    await soon(() => list().innerText()).toMatch(/failing[^]*Faulted: zero_division/);
    await page.getByRole("combobox", { name: "With the outcome" }).selectOption("");
    await page.getByRole("searchbox", { name: "Search the runs" }).fill("success pick");
    await soon(() => list().getByRole("listitem").count()).toBe(1);
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("runs");
    await page.emulateMedia({ colorScheme: "dark" });
    await soon(() => findings(page)).toEqual([]);
    await fixture.screenshot("runs-dark");
    await page.emulateMedia({ colorScheme: "light" });
  });

  it("opens as it was live, and is scrubbed through the same moments", async () => {
    await page.getByRole("button", { name: `Run ${picked.id} of pick` }).click();
    await settled(page);
    await soon(() => status()).toBe("Ended: success");
    await soon(() => banner().innerText()).toContain(`Run ${picked.id} of pick is stored`);
    await soon(() => page.locator(".run-button:enabled").allInnerTexts()).toEqual(["Run again"]);
    if ((await page.getByRole("list", { name: "Macro steps" }).count()) === 0) await page.getByRole("tab", { name: "Derivation" }).click();
    await soon(() => page.getByRole("list", { name: "Macro steps" }).getByRole("listitem").count()).toBe(picked.step);
    const stored = [];
    for (const step of [2, 4, picked.step - 1]) stored.push(await seenAt(step));
    expect(stored).toEqual(live);
    await settled(page);
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("run-scrubbed");
    const slider = banner().getByRole("slider", { name: "Macro step" });
    await slider.press("Home");
    await soon(moment).toMatch(/^1\./);
    await page.keyboard.press("Escape");
    await soon(moment).toBeNull();
    await page.goBack();
    await soon(moment).toMatch(/^1\./);
  });

  it("is where a link leads, also to a moment of it", async () => {
    await page.goto(`${fixture.url}/pro/?run=${picked.id}&at=4.0`);
    await soon(() => banner().innerText()).toContain("You look at step 4.0.");
    await page.goto(`${fixture.url}/pro/?run=${picked.id}`);
    await soon(() => banner().innerText()).toContain("is stored");
    await page.reload();
    await soon(() => banner().innerText()).toContain("is stored");
  });

  it("says beside the condition of a port what it was at the end, and at the moment that is looked at", async () => {
    const see = async (document: string, address: string, port: string) => {
      await page.goto(`${fixture.url}/pro/?run=${address}&edit=${document}`);
      await settled(page);
      await editPage(fixture).port(port).click();
    };
    const now = () => page.locator(".row-now").innerText();
    await see("pick", `${picked.id}&at=2`, "Pick/GetPose.success");
    await soon(now).toMatch(/at step 2\.\d+: false$/);
    await page.goto("about:blank"); // it may still ask for what is deleted
    await fixture.send("PUT", "/documents/halted", { rcm: 1, root: { state: "Root", entry: "svc.timer.start(3600)", ports: [{ name: "timed", when: "svc.timer.start.result" }] } });
    const { id } = await send("POST", "/cores", { document: "halted" });
    for (const command of ["start", "stop"]) await send("POST", `/cores/${id}/${command}`);
    await fixture.send("DELETE", `/cores/${id}`);
    await see("halted", id, "Root.timed");
    await soon(now).toBe("at the end: unknown"); // no response had come
    await page.goto("about:blank");
    await fixture.send("DELETE", `/runs/${id}`);
  });

  it("goes as one file to the disk, and from there onto the page again", async () => {
    await page.goto(`${fixture.url}/pro/?run=${picked.id}&runs=1`);
    const row = list().getByRole("listitem", { name: `Run ${picked.id}`, exact: true });
    const [file] = await Promise.all([page.waitForEvent("download"), row.getByRole("link", { name: "Download" }).click()]);
    expect(file.suggestedFilename()).toBe(`run-${picked.id}.json`);
    const text = await textOf(file);
    await dropOnto(page, text);
    const copy = String(Number(picked.id) + 3);
    await soon(() => banner().innerText()).toContain(`Run ${copy} of pick is stored`);
    await soon(() => status()).toBe("Ended: success");
    await soon(() => page.getByRole("dialog").count()).toBe(0);
  });

  it("is dropped onto another server, which shows the same moments", async () => {
    const { step, digest: before } = { step: 4, digest: await digestAt(page, fixture.url, picked.id, 4) };
    const text = await (await fetch(`${fixture.url}/api/v1/runs/${picked.id}/export`)).text();
    const other = await openFixture();
    try {
      other.page.setDefaultTimeout(kPatience);
      await other.page.goto(`${other.url}/pro/`);
      await other.page.getByRole("region", { name: "Start" }).waitFor();
      await dropOnto(other.page, text);
      await soon(() => other.page.getByRole("region", { name: "Past" }).innerText()).toContain("of pick is stored");
      await soon(() => other.page.getByRole("status", { name: "Run status" }).locator("strong").innerText()).toBe("Ended: success");
      const { runs } = (await other.send("GET", "/runs")) as { readonly runs: readonly { readonly id: string; readonly imported: boolean }[] };
      expect(runs.map(({ imported }) => imported)).toEqual([true]);
      expect(await digestAt(other.page, other.url, runs[0]?.id ?? "", step)).toBe(before);
      await other.screenshot("run-on-another-server");
    } finally {
      await other.close();
    }
  });

  it("is deleted for good when that is confirmed", async () => {
    await page.getByRole("button", { name: "Runs", exact: true }).click();
    const row = list().getByRole("listitem", { name: `Run ${picked.id}`, exact: true });
    await row.getByRole("button", { name: "Delete", exact: true }).click();
    await row.getByRole("button", { name: "Keep it" }).click();
    expect(await row.count()).toBe(1);
    await row.getByRole("button", { name: "Delete", exact: true }).click();
    await row.getByRole("button", { name: `Delete run ${picked.id}` }).click();
    await soon(() => row.count()).toBe(0);
    await expect(fixture.send("GET", `/runs/${picked.id}`)).rejects.toThrow("404");
    await page.keyboard.press("Escape");
    await soon(() => page.getByRole("dialog").count()).toBe(0);
    await soon(() => page.evaluate(() => location.search)).not.toContain("runs");
  });
});
