// Runs that are interrupted, and go on when a person says so: the server is killed while a task runs, and started again; or its disk is full.
import { spawn, type ChildProcess } from "node:child_process";
import { devices, type Page } from "playwright-core";
import { openFixture, settled, type Fixture } from "./fixture";
import { kSoon } from "./patience";

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
});
afterAll(() => fixture.close());

interface CoreAnswer {
  readonly id: string;
  readonly status: string;
  readonly step: number;
}

const send = async (method: string, path: string, body?: unknown) => (await fixture.send(method, path, body)) as CoreAnswer;

/** Waits for an hour; if that call is lost, for a moment, and is over. */
const root = {
  state: "Root",
  first: "Wait",
  children: [
    { state: "Wait", entry: "svc.timer.start(3600)", ports: [{ name: "lost", when: "svc.timer.start.error", to: "After" }] },
    { state: "After", entry: "svc.timer.start(0.05)", ports: [{ name: "done", when: "svc.timer.start.result" }] },
  ],
  ports: [{ name: "recovered", when: "chi.After.port.done" }],
};
/** Stores an entry of its journal every tenth of a second. */
const beating = {
  state: "Root",
  first: "Tick",
  children: [
    { state: "Tick", entry: "svc.timer.start(0.1)", ports: [{ name: "next", when: "svc.timer.start.result", to: "Tock" }, { name: "lost", when: "svc.timer.start.error", to: "Tock" }] },
    { state: "Tock", entry: "svc.timer.start(0.1)", ports: [{ name: "next", when: "svc.timer.start.result", to: "Tick" }, { name: "lost", when: "svc.timer.start.error", to: "Tick" }] },
  ],
  ports: [{ name: "never", when: "False" }],
};

const notice = (of: Page) => of.getByRole("alert", { name: "Interruption" });
const status = (of: Page) => of.getByRole("status", { name: "Run status" }).locator("strong").innerText();
const enabled = () => page.getByRole("toolbar", { name: "Run" }).locator("button.run-button:enabled").allInnerTexts();
const watched = (of: Page) => of.getByRole("combobox", { name: "Watched run" });
const isActive = (path: string) => page.locator(`.canvas [data-path="${path}"]`).first().getAttribute("data-active");

describe("a run that its server has left", () => {
  let run: CoreAnswer;

  it("is shown as it was, with the loss of the server, while the server is away", async () => {
    await send("PUT", "/documents/waiting", { rcm: 1, name: "waiting", root });
    const { id } = await send("POST", "/cores", { document: "waiting" });
    await send("POST", `/cores/${id}/start`);
    await page.goto(`${fixture.url}/pro/`);
    await expect.poll(() => isActive("Root/Wait"), kSoon).toBe("true");
    await expect.poll(() => status(page), kSoon).toBe("Running");
    run = await send("GET", `/cores/${id}`);
    // Newer than the run, and waits for nobody.
    await send("POST", "/cores", { document: "waiting" });
    await fixture.kill();
    await page.getByText("Connection lost", { exact: true }).waitFor(kSoon);
    await expect.poll(() => page.getByRole("alert", { name: "Server lost" }).innerText(), kSoon).toContain(`Server lost at step ${run.step} of run ${run.id}: pause and stop cannot reach the robot`);
    await expect.poll(() => status(page), kSoon).toBe("Not known; last: Running");
    await expect.poll(() => watched(page).locator("option:checked").innerText(), kSoon).toContain("Not known; last: Running");
    await expect.poll(() => enabled(), kSoon).toEqual([]);
    expect(await isActive("Root/Wait")).toBe("true");
    await expect.poll(() => page.getByRole("button", { name: "Load", exact: true }).isDisabled(), kSoon).toBe(true);
    await expect.poll(() => page.getByRole("checkbox", { name: "Follow edits while it runs" }).isDisabled(), kSoon).toBe(true);
    await expect.poll(() => page.locator(".prop-head .pill").innerText(), kSoon).toBe("Not known; last: Running");
    await expect.poll(() => page.getByRole("heading", { name: "Active when last heard of" }).count(), kSoon).toBe(1);
    await expect.poll(() => page.locator(".workspace").evaluate((part) => getComputedStyle(part).filter), kSoon).toBe("grayscale(1)");
    await fixture.screenshot("lost");
  });

  it("is interrupted when the server is back: the page says what happened, and what may be done", async () => {
    await fixture.restart();
    await notice(page).waitFor(kSoon);
    await expect.poll(() => page.getByRole("alert", { name: "Server lost" }).count(), kSoon).toBe(0);
    const restarted = page.getByRole("status", { name: "Server restarted" });
    await expect.poll(() => restarted.innerText(), kSoon).toMatch(new RegExp(`^Server restarted\\s+One run was interrupted:\\s+Run ${run.id} of waiting, shown`));
    for (const text of [`Run ${run.id} is interrupted`, "Open calls were answered unavailable", "Nothing moves until someone resumes"]) await expect.poll(() => notice(page).innerText(), kSoon).toContain(text);
    await expect.poll(() => status(page), kSoon).toBe("Interrupted");
    await expect.poll(() => watched(page).inputValue(), kSoon).toBe(run.id);
    await expect.poll(() => watched(page).locator("option:checked").innerText(), kSoon).toContain("Interrupted");
    await expect.poll(() => enabled(), kSoon).toEqual(["Resume", "Micro step", "Macro step", "Stop"]);
    await expect.poll(() => page.getByText("Connected", { exact: true }).count(), kSoon).toBe(1);
    await settled(page);
    await fixture.screenshot("interrupted");
    await restarted.getByRole("button", { name: "Dismiss" }).click();
    await expect.poll(() => restarted.count(), kSoon).toBe(0);
  });

  it("is what a page shows that is opened now, also on a phone, where each way out has a name", async () => {
    const context = await fixture.openContext({ ...devices["Pixel 7"] });
    const phone = await context.newPage();
    await phone.goto(`${fixture.url}/pro/`);
    await notice(phone).waitFor(kSoon);
    await expect.poll(() => watched(phone).inputValue(), kSoon).toBe(run.id);
    await expect.poll(() => phone.getByRole("toolbar", { name: "Run" }).locator("button.run-button:enabled span:visible").allInnerTexts(), kSoon).toEqual(["Resume", "Micro step", "Macro step", "Stop"]);
    const width = phone.viewportSize()?.width ?? 0;
    expect(await phone.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
    await settled(phone);
    await fixture.screenshot("interrupted-phone", phone);
    await context.close();
  });

  it("does not move by itself", async () => {
    expect(await send("GET", `/cores/${run.id}`)).toMatchObject({ status: "interrupted", step: run.step });
    expect(await isActive("Root/Wait")).toBe("true");
  });

  it("is still shown after the page is loaded again, and goes on by key from the lost call", async () => {
    await page.reload();
    await notice(page).waitFor(kSoon);
    await expect.poll(() => page.url(), kSoon).toBe(`${fixture.url}/pro/?run=${run.id}`);
    await page.keyboard.press("F5");
    await expect.poll(() => status(page), kSoon).toBe("Ended: recovered");
    await expect.poll(() => notice(page).count(), kSoon).toBe(0);
    await expect.poll(() => watched(page).inputValue(), kSoon).toBe(run.id);
  });
});

/** Until the result is called, every write of the server to a file fails as on a full disk. */
async function fillDisk(): Promise<() => Promise<void>> {
  const calls = "pwrite64,pwritev,ftruncate,fallocate";
  const tracer: ChildProcess = spawn("strace", ["-f", "-q", "-p", String(fixture.pid()), "-e", `trace=${calls}`, "-e", `inject=${calls}:error=ENOSPC`, "-o", "/dev/null"], { stdio: "ignore" });
  await new Promise((resolve, reject) => tracer.once("spawn", resolve).once("error", reject));
  return async () => {
    if (tracer.exitCode !== null) throw new Error(`strace ended with status ${tracer.exitCode}`);
    const ended = new Promise((resolve) => tracer.once("exit", resolve));
    tracer.kill("SIGINT");
    await ended;
  };
}

describe("a run whose journal cannot be stored", () => {
  const problem = () => page.locator(".problem");
  let free: (() => Promise<void>) | undefined;
  afterAll(() => free?.());

  it("is interrupted, and the page says why", async () => {
    await send("PUT", "/documents/beating", { rcm: 1, name: "beating", root: beating });
    const { id } = await send("POST", "/cores", { document: "beating" });
    await watched(page).selectOption(id);
    await send("POST", `/cores/${id}/start`);
    await expect.poll(() => status(page), kSoon).toBe("Running");
    free = await fillDisk();
    await notice(page).waitFor(kSoon);
    await expect.poll(() => notice(page).innerText(), kSoon).toContain(`Run ${id} is interrupted: its journal cannot be stored`);
  });

  it("refuses to go on while the disk is full: the message stays until it is dismissed, and the server is not lost", async () => {
    fixture.allowError(/^Failed to load resource: the server responded with a status of 507 /);
    await page.keyboard.press("F5");
    await problem().waitFor(kSoon);
    await expect.poll(() => status(page), kSoon).toBe("Interrupted");
    await page.getByRole("tab", { name: "Log" }).click();
    await fixture.screenshot("interrupted-disk");
    await expect.poll(() => page.getByText("Connected", { exact: true }).count(), kSoon).toBe(1);
    expect(await problem().count()).toBe(1);
    await page.getByRole("button", { name: "Dismiss" }).click();
    await expect.poll(() => problem().count(), kSoon).toBe(0);
  });

  it("goes on when there is space again", async () => {
    await free?.();
    free = undefined;
    await page.keyboard.press("F5");
    await expect.poll(() => status(page), kSoon).toBe("Running");
    await expect.poll(() => notice(page).count(), kSoon).toBe(0);
    await expect.poll(() => problem().count(), kSoon).toBe(0);
    await page.keyboard.press("F8");
    await expect.poll(() => status(page), kSoon).toBe("Stopped");
  });
});

describe("a server that ends", () => {
  it("says so to its pages", async () => {
    await page.goto(`${fixture.url}/pro/`);
    await page.getByText("Connected", { exact: true }).waitFor(kSoon);
    await fixture.terminate();
    const lost = page.getByRole("alert", { name: "Server lost" });
    await lost.waitFor(kSoon);
    await expect.poll(() => lost.innerText(), kSoon).toContain("The server has ended");
    await fixture.restart();
    await lost.waitFor({ state: "detached", ...kSoon });
  });
});
