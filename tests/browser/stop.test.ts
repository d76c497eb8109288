// STOP on the real server: by button and key wherever the focus is, without login, without a stream, by either port; what is said if none answers; and the reset.
import { execFileSync } from "node:child_process";
import { devices, type Page } from "playwright-core";
import { watchArm, type Arm } from "./arm";
import { findings } from "./axe";
import { tap } from "./fingers";
import { binary, openFixture, openPrepared, settled, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

const kPassword = "correct horse battery";

const stopButton = (page: Page) => page.getByRole("button", { name: "STOP", exact: true });
const banner = (page: Page) => page.getByRole("region", { name: "The cell is stopped" });
const warning = (page: Page) => page.locator(".stop-warning");
/** Whether nothing in the bar above covers anything else, nor the button. */
const inOneRow = (page: Page) =>
  page.evaluate(() => {
    const boxes = [...document.querySelectorAll(".topbar :is(button, select), .connection, .stop-button")].map((part) => part.getBoundingClientRect()).filter(({ width }) => width > 0);
    return boxes.length > 8 && boxes.every(({ right }, i) => boxes.slice(i + 1).every(({ left }) => left >= right));
  });
const resetDialog = (page: Page) => page.getByRole("dialog", { name: "Reset the stop?" });

const move = (base: number) => `svc.robot.move({'joints': [${base}, -0.35, 0, 1.6, 0, -1.19, 0]}, speed=0.2)`;
const turn = (state: string, other: string, base: number) => ({
  state, entry: move(base), ports: [{ name: "next", when: "svc.robot.move.result", to: other }, { name: "again", when: "svc.robot.move.error", to: state }],
});
/** Moves to and fro, and again whenever that fails: what a stop has to end. */
const insisting = { rcm: 1, name: "insisting", root: { state: "Root", first: "To", children: [turn("To", "Fro", 1.2), turn("Fro", "To", 0)] } };
/** Moves once; ends at `failed` if it may not. */
const moving = {
  rcm: 1, name: "moving",
  root: { state: "Root", entry: move(0.3), ports: [{ name: "there", when: "svc.robot.move.result" }, { name: "failed", when: "svc.robot.move.error" }] },
};

interface Control {
  readonly stopped: { readonly by: string } | null;
  readonly stop_ports: readonly { readonly stop_port: number }[];
}

describe("a server without accounts", () => {
  let fixture: Fixture;
  let page: Page;
  let arm: Arm;
  beforeAll(async () => {
    fixture = await openFixture();
    ({ page } = fixture);
    page.setDefaultTimeout(kPatience);
    // That requests are looked at is told to a page beside its keys: what comes first is not sure. So they are from the beginning.
    await page.route("**/a path that nobody asks for", (route) => route.continue());
    arm = watchArm(fixture.url);
    for (const document of [insisting, moving]) await fixture.send("PUT", `/documents/${document.name}`, document);
    await page.setViewportSize({ width: 1366, height: 768 });
  });
  afterAll(async () => {
    arm.close();
    await fixture.close();
  });
  // A test that has failed leaves nothing that moves.
  afterEach(async () => {
    await fixture.send("POST", "/stop");
    await fixture.send("POST", "/stop/reset");
  });

  const control = async () => (await fixture.send("GET", "/control")) as Control;
  const statusOf = async (id: string) => ((await fixture.send("GET", `/cores/${id}`)) as { readonly status: string }).status;
  const make = async (document: string) => ((await fixture.send("POST", "/cores", { document })) as { readonly id: string }).id;
  /** A run that moves the arm, on the page. */
  async function start(on = page): Promise<string> {
    const id = await make("insisting");
    await on.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(on);
    await fixture.send("POST", `/cores/${id}/start`);
    await expect.poll(arm.moves, kSoon).toBe(true);
    return id;
  }
  async function stands(id: string): Promise<void> {
    await expect.poll(() => statusOf(id), kSoon).toBe("aborted");
    await expect.poll(arm.moves, kSoon).toBe(false);
    expect((await control()).stopped?.by).toBe("somebody at 127.0.0.1");
  }

  it("has the button in a corner that covers nothing, large, in windows of usual size, in both themes", async () => {
    await start();
    for (const [width, height] of [[1366, 768], [2560, 1440]] as const) {
      await page.setViewportSize({ width, height });
      await expect.poll(async () => (await stopButton(page).boundingBox())?.height, kSoon).toBeGreaterThanOrEqual(44);
      await expect.poll(() => inOneRow(page), kSoon).toBe(true);
      await fixture.screenshot(`stop-${width}`);
    }
    await page.setViewportSize({ width: 1366, height: 768 });
    expect(await findings(page)).toEqual([]);
    await page.emulateMedia({ colorScheme: "dark" });
    await page.waitForTimeout(500); // colours change slowly
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("stop-dark");
    await page.emulateMedia({ colorScheme: "light" });
    await page.waitForTimeout(500);
  });

  it("stands by one click, which every page says", async () => {
    const id = await start();
    const second = await fixture.openPage({ width: 2560, height: 1440 });
    await second.getByText("Connected", { exact: true }).waitFor();
    await stopButton(page).click();
    await stands(id);
    for (const each of [page, second]) {
      await expect.poll(() => banner(each).innerText(), kSoon).toMatch(/STOPPED by somebody at 127\.0\.0\.1 at \d\d:\d\d:\d\d\s+All runs have ended\. Nothing moves until the reset, and the reset starts nothing\./);
    }
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("stopped-1366");
    await fixture.screenshot("stopped-2560", second);
    await second.context().close();
  });

  it("stands by the key while a text field has the focus, which keeps it and gets nothing", async () => {
    const id = await start();
    const search = page.getByRole("searchbox", { name: "Search the model" });
    await search.fill("Fro");
    await page.keyboard.press("F3");
    await stands(id);
    expect(await search.inputValue()).toBe("Fro");
    expect(await search.evaluate((field) => document.activeElement === field)).toBe(true);
  });

  it("stands by key and button while a dialog is open, which stays", async () => {
    const dialogs = [
      ["Control+o", page.getByRole("dialog", { name: "Documents" })],
      ["F1", page.getByRole("dialog", { name: "Help" })],
      ["?", page.getByRole("dialog", { name: "Keys and mouse" })],
    ] as const;
    for (const [keys, dialog] of dialogs) {
      let id = await start();
      await page.keyboard.press(keys);
      await dialog.waitFor();
      await page.keyboard.press("F3");
      await stands(id);
      expect(await dialog.isVisible()).toBe(true);
      await fixture.send("POST", "/stop/reset");
      id = await make("insisting");
      await fixture.send("POST", `/cores/${id}/start`);
      await expect.poll(arm.moves, kSoon).toBe(true);
      await stopButton(page).click();
      await stands(id);
      expect(await dialog.isVisible()).toBe(true);
      await page.locator(".stop-told", { hasText: "STOPPED by somebody" }).waitFor();
      expect(await findings(page)).toEqual([]);
      await fixture.screenshot(`stopped-dialog-${keys.replace(/\W/, "")}`);
      await page.keyboard.press("Escape");
      await dialog.waitFor({ state: "detached" });
      expect(await stopButton(page).isVisible()).toBe(true);
      await fixture.send("POST", "/stop/reset");
    }
  });

  it("stands by the keyboard alone, also from within a dialog", async () => {
    const id = await start();
    await page.keyboard.press("Control+o");
    await page.getByRole("dialog", { name: "Documents" }).waitFor();
    await stopButton(page).focus();
    await page.keyboard.press("Enter");
    await stands(id);
    expect(await page.getByRole("dialog", { name: "Documents" }).isVisible()).toBe(true);
  });

  it("tells its key in the help, at the button and to screen readers", async () => {
    await page.goto(`${fixture.url}/pro/`);
    await page.getByText("Connected", { exact: true }).waitFor();
    expect(await stopButton(page).getAttribute("aria-keyshortcuts")).toBe("F3");
    expect(await stopButton(page).getAttribute("title")).toContain("STOP (F3)");
    await page.keyboard.press("?");
    expect(await page.getByRole("dialog", { name: "Keys and mouse" }).innerText()).toMatch(/F3\s+STOP: the robot brakes/);
    await page.keyboard.press("Escape");
  });

  it("starts and steps nothing while it is stopped, and says why, until the reset, which starts nothing", async () => {
    await fixture.send("POST", "/stop");
    const id = await make("moving");
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(page);
    await banner(page).waitFor();
    const bar = page.getByRole("toolbar", { name: "Run" });
    for (const name of ["Start", "Micro step", "Macro step"]) {
      const button = bar.getByRole("button", { name, exact: true });
      await expect.poll(async () => [await button.isDisabled(), await button.getAttribute("title")], kSoon).toEqual([true, expect.stringContaining("the cell is stopped")]);
    }
    await page.keyboard.press("F5");
    await page.getByText("Not done: the cell is stopped.").waitFor();
    await banner(page).getByRole("button", { name: "Reset…" }).click();
    expect(await resetDialog(page).innerText()).toContain("Is nobody in the reach of the robot? The reset moves nothing.");
    await expect.poll(() => page.evaluate(() => document.activeElement?.textContent), { ...kSoon, message: "what is safe has the focus" }).toBe("Keep it stopped");
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("stop-reset");
    await page.keyboard.press("Enter");
    await resetDialog(page).waitFor({ state: "detached" });
    expect((await control()).stopped).not.toBeNull();
    await banner(page).getByRole("button", { name: "Reset…" }).click();
    await resetDialog(page).getByRole("button", { name: "Nobody is there: reset" }).click();
    await banner(page).waitFor({ state: "detached" });
    expect([(await control()).stopped, await statusOf(id), arm.moves()]).toEqual([null, "ready", false]);
    await expect.poll(() => bar.getByRole("button", { name: "Start" }).isEnabled(), kSoon).toBe(true);
  });

  it("is stopped again from within the question of the reset", async () => {
    await fixture.send("POST", "/stop");
    await page.goto(`${fixture.url}/pro/`);
    await banner(page).getByRole("button", { name: "Reset…" }).click();
    await resetDialog(page).waitFor();
    await fixture.send("POST", "/stop/reset");
    await banner(page).waitFor({ state: "detached" });
    await stopButton(page).click();
    await banner(page).waitFor();
    expect((await control()).stopped).not.toBeNull();
  });

  it("tells which run has the robot, and what became of another one that wanted it", async () => {
    const first = await start();
    const reserved = page.getByRole("list", { name: "Reserved services" });
    await expect.poll(() => reserved.first().innerText(), kSoon).toBe("robot is reserved by this run");
    const second = await make("moving");
    await fixture.send("POST", `/cores/${second}/start`);
    await expect.poll(() => statusOf(second), kSoon).toBe("ended");
    await page.goto(`${fixture.url}/pro/?run=${second}`);
    await settled(page);
    const properties = page.getByRole("complementary", { name: "Properties" });
    await expect.poll(() => properties.innerText(), kSoon).toContain(`robot.move was refused: run ${first} has robot until it is over. Only one run at a time moves a service`);
    await expect.poll(() => properties.innerText(), kSoon).toContain(`robot is reserved by run ${first}`);
    await fixture.screenshot("stop-leased");
    await page.getByRole("tab", { name: "Cell" }).click();
    await page.getByRole("region", { name: "Cell" }).getByRole("list", { name: "Reserved services" }).waitFor();
    await fixture.screenshot("stop-leased-cell");
  });

  it("stands also while the stream is cut", async () => {
    const cut = await (await fixture.openContext({ viewport: { width: 1366, height: 768 } })).newPage();
    let isCut = false;
    const open: { readonly close: () => Promise<void> }[] = [];
    await cut.routeWebSocket(/\/api\/v1\/stream/, (socket) => {
      if (isCut) return void socket.close();
      socket.connectToServer();
      open.push(socket);
    });
    const id = await start(cut);
    isCut = true;
    for (const socket of open) await socket.close();
    await cut.getByText("Connection lost", { exact: true }).waitFor();
    expect(await stopButton(cut).isVisible()).toBe(true);
    await expect.poll(() => inOneRow(cut), kSoon).toBe(true);
    await fixture.screenshot("stop-lost", cut);
    await stopButton(cut).click();
    await stands(id);
    await banner(cut).waitFor();
    await fixture.screenshot("stopped-lost", cut);
    await expect.poll(() => banner(cut).getByRole("button", { name: "Reset…" }).isDisabled(), kSoon).toBe(true);
    await cut.context().close();
  });

  it.each(["its own port", "the ordinary port"])("stands by the other one if %s does not answer", async (which) => {
    fixture.allowError(/ERR_FAILED .*\/api\/v1\/stop\)/);
    const own = (await control()).stop_ports[0]?.stop_port ?? 0;
    const id = await start();
    const gone = which === "its own port" ? `http://127.0.0.1:${own}/api/v1/stop` : `${fixture.url}/api/v1/stop`;
    let tries = 0;
    await page.route(gone, (route) => {
      tries++;
      return route.abort();
    });
    await stopButton(page).click();
    await stands(id);
    await banner(page).waitFor();
    expect(tries).toBeGreaterThan(0);
    await expect.poll(() => warning(page).isVisible(), kSoon).toBe(false);
    await page.unroute(gone);
  });

  it("says plainly that a stop did not come through, gives it up, and is stopped by the next press", async () => {
    fixture.allowError(/ERR_FAILED .*\/api\/v1\/stop\)/);
    const id = await start();
    let tries = 0;
    await page.route("**/api/v1/stop", (route) => {
      tries++;
      return route.abort();
    });
    await page.keyboard.press("F3");
    await expect.poll(() => warning(page).innerText(), kSoon).toContain("STOP has no answer yet.");
    await expect.poll(() => warning(page).innerText(), kSoon).toMatch(/STOP did NOT reach the server\.\s+Use the robot's own emergency stop\./);
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("stop-failed");
    await page.setViewportSize({ width: 390, height: 844 });
    await fixture.screenshot("stop-failed-phone");
    await page.setViewportSize({ width: 1366, height: 768 });
    const tried = tries;
    expect(tried).toBe(20);
    await page.unroute("**/api/v1/stop");
    await page.waitForTimeout(1500);
    expect([tries, (await control()).stopped, await statusOf(id)], "it does not come later").toEqual([tried, null, "running"]);
    expect(await warning(page).isVisible()).toBe(true);
    await stopButton(page).click();
    await stands(id);
    await warning(page).waitFor({ state: "hidden" });
  });

  it("is stopped from a phone, where the button is a bar that covers nothing", async () => {
    const phone = await (await fixture.openContext({ ...devices["Pixel 7"] })).newPage();
    phone.setDefaultTimeout(kPatience);
    const id = await start(phone);
    expect((await stopButton(phone).boundingBox())?.height).toBeGreaterThanOrEqual(64);
    await fixture.screenshot("stop-phone", phone);
    await phone.evaluate(() => scrollTo(0, document.documentElement.scrollHeight));
    await fixture.screenshot("stop-phone-end", phone);
    const end = () => phone.locator(".app").evaluate((app) => Math.max(...[...app.children].map((child) => child.getBoundingClientRect().bottom)));
    // Texts end within a pixel.
    await expect.poll(async () => (await end()) - ((await phone.locator("#stop-layer").boundingBox())?.y ?? 0), kSoon).toBeLessThanOrEqual(0.5);
    await stopButton(phone).tap();
    await stands(id);
    await banner(phone).waitFor();
    expect(await findings(phone)).toEqual([]);
    await fixture.screenshot("stopped-phone", phone);
    await phone.getByRole("button", { name: "Documents" }).click();
    await phone.getByRole("dialog", { name: "Documents" }).waitFor();
    await fixture.screenshot("stopped-phone-dialog", phone);
    await phone.context().close();
  });

  it.each([
    [1366, 768],
    [2560, 1440],
    [360, 640],
    [390, 844],
    [412, 915],
  ])("leaves the page of %d x %d pixels exactly what the bar does not take", async (width, height) => {
    for (const path of ["/pro/", "/one/", "/display/?name=phone1"]) {
      const other = await (await fixture.openContext({ viewport: { width, height } })).newPage();
      await other.goto(`${fixture.url}${path}`);
      await stopButton(other).waitFor();
      const frame = other.locator(".app, .one, #root:has(.display)").first();
      await frame.waitFor();
      const measured = () => other.evaluate(() => {
        const layer = document.querySelector("#stop-layer")?.getBoundingClientRect() ?? new DOMRect();
        const found = document.querySelector(".app, .one, #root:has(.display)");
        return { begins: innerHeight - layer.top, left: found === null ? Number.NaN : parseFloat(getComputedStyle(found).paddingBottom), isBelow: layer.bottom >= innerHeight };
      });
      // Elsewhere it lies in the row above, and takes nothing.
      const differs = async () => {
        const { begins, left, isBelow } = await measured();
        return { isBelow, by: left - (isBelow ? begins : 0) };
      };
      await expect.poll(differs, { ...kSoon, message: path }).toEqual({ isBelow: width <= 760, by: 0 });
      await other.context().close();
    }
  });

  it("is stopped from a display by one tap, and reset there", async () => {
    const phone = await (await fixture.openContext({ ...devices["Pixel 7"] })).newPage();
    phone.setDefaultTimeout(kPatience);
    await phone.goto(`${fixture.url}/display/?name=phone`);
    await phone.getByText("Connected", { exact: true }).waitFor();
    const id = await start();
    expect((await stopButton(phone).boundingBox())?.height).toBeGreaterThanOrEqual(64);
    await fixture.screenshot("stop-display", phone);
    await stopButton(phone).tap();
    await stands(id);
    await banner(phone).waitFor();
    expect(await findings(phone)).toEqual([]);
    await fixture.screenshot("stopped-display", phone);
    await tap(banner(phone).getByRole("button", { name: "Reset…" }));
    await fixture.screenshot("stop-display-reset", phone);
    await tap(resetDialog(phone).getByRole("button", { name: "Nobody is there: reset" }));
    await banner(phone).waitFor({ state: "detached" });
    expect((await control()).stopped).toBeNull();
    await phone.setViewportSize({ width: 1366, height: 768 });
    await fixture.screenshot("stop-display-1366", phone);
    await phone.context().close();
  });
});

describe("a server with accounts", () => {
  let fixture: Fixture;
  beforeAll(async () => {
    fixture = await openPrepared((data) => {
      for (const [name, role] of [["ada", "admin"], ["otto", "operator"], ["olga", "observer"]] as const)
        execFileSync(binary, ["account", "add", name, "--role", role, "--data", data], { input: `${kPassword}\n` });
    });
  });
  afterAll(() => fixture.close());

  const stopped = async () => ((await fixture.send("GET", "/control")) as Control).stopped !== null;
  async function open(path: string, phone = false): Promise<Page> {
    const page = await (await fixture.openContext(phone ? { ...devices["Pixel 7"] } : { viewport: { width: 1366, height: 768 } })).newPage();
    page.setDefaultTimeout(kPatience);
    await page.goto(`${fixture.url}${path}`);
    return page;
  }
  async function logIn(page: Page, name: string): Promise<void> {
    await page.getByLabel("Name", { exact: true }).fill(name);
    await page.getByLabel("Password", { exact: true }).fill(kPassword);
    await page.keyboard.press("Enter");
    await page.getByText("Connected", { exact: true }).waitFor();
  }
  async function reset(page: Page): Promise<void> {
    await banner(page).getByRole("button", { name: "Reset…" }).click();
    await resetDialog(page).getByRole("button", { name: "Nobody is there: reset" }).click();
    await banner(page).waitFor({ state: "detached" });
  }

  it("is stopped from the login, by button and by key in its fields; an observer does not reset it, an operator does", async () => {
    fixture.allowError(/status of 401/);
    const page = await open("/pro/");
    await page.getByRole("dialog", { name: "Log in to RACE" }).waitFor();
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("stop-login", page);
    await stopButton(page).click();
    await expect.poll(stopped, kSoon).toBe(true);
    await page.locator(".stop-told", { hasText: "STOPPED by somebody" }).waitFor();
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("stopped-login", page);

    const observer = await open("/pro/");
    await logIn(observer, "olga");
    const button = banner(observer).getByRole("button", { name: "Reset…" });
    await button.waitFor();
    await expect.poll(async () => [await button.isDisabled(), await button.getAttribute("title")], kSoon).toEqual([true, "this needs the role operator, and your account has the role observer"]);
    await expect.poll(() => banner(observer).innerText(), kSoon).toContain("Reset: this needs the role operator");
    await fixture.screenshot("stopped-observer", observer);
    await observer.context().close();

    await logIn(page, "otto");
    await page.getByRole("combobox", { name: "Document" }).selectOption("demonstrator");
    await page.getByRole("button", { name: "Arguments…" }).waitFor();
    await expect.poll(() => inOneRow(page), kSoon).toBe(true);
    await fixture.screenshot("stopped-operator", page);
    await reset(page);
    await stopButton(page).click();
    await expect.poll(stopped, kSoon).toBe(true);
    await reset(page);

    const other = await open("/pro/");
    await other.getByLabel("Password", { exact: true }).fill("correct");
    await other.keyboard.press("F3");
    await expect.poll(stopped, kSoon).toBe(true);
    expect(await other.getByLabel("Password", { exact: true }).inputValue()).toBe("correct");
    await other.context().close();
    await reset(page);
    await page.context().close();
  });

  it("is stopped from the login of a display", async () => {
    const phone = await open("/display/?name=phone", true);
    await phone.getByRole("form", { name: "Log in" }).waitFor();
    await fixture.screenshot("stop-display-login", phone);
    await stopButton(phone).tap();
    await expect.poll(stopped, kSoon).toBe(true);
    await banner(phone).waitFor();
    expect(await findings(phone)).toEqual([]);
    await fixture.screenshot("stopped-display-login", phone);
    await logIn(phone, "otto");
    await reset(phone);
    expect(await stopped()).toBe(false);
    await phone.context().close();
  });
});
