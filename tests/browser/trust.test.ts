// The page on trust, on a real server that a network reaches over TLS: what a phone sees before it trusts the server, and on a server without a network.
import { execFileSync } from "node:child_process";
import { networkInterfaces } from "node:os";
import type { BrowserContextOptions, Page } from "playwright-core";
import { findings } from "./axe";
import { binary, freePort, openFixture, openPrepared, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

const kPassword = "correct horse battery";
const kPhone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, userAgent: "Mozilla/5.0 (Linux; Android 14; Pixel 8) AppleWebKit/537.36 (KHTML, like Gecko) Chrome/130.0.0.0 Mobile Safari/537.36" };
const kPrivate = /^(?:10\.|192\.168\.|172\.(?:1[6-9]|2\d|3[01])\.|f[cd])/;

/** An address of this machine in a private network, as a URL has it. */
const own = Object.values(networkInterfaces())
  .flat()
  .find((each) => each !== undefined && !each.internal && kPrivate.test(each.address));
const host = own === undefined ? undefined : own.family === "IPv6" ? `[${own.address}]` : own.address;

const section = (page: Page, name: string) => page.locator("details").filter({ has: page.locator("summary", { hasText: new RegExp(`^${name}$`) }) });
const stopButton = (page: Page) => page.getByRole("button", { name: "STOP", exact: true });
const banner = (page: Page) => page.getByRole("region", { name: "The cell is stopped" });
const openSections = (page: Page) => page.locator("details[open] > summary").allInnerTexts();

describe("a server without a network", () => {
  let fixture: Fixture;
  beforeAll(async () => {
    fixture = await openFixture();
    fixture.page.setDefaultTimeout(kPatience);
  });
  afterAll(() => fixture.close());

  it("says how it gets one", async () => {
    const { page } = fixture;
    fixture.allowError(/status of 404/);
    await page.goto(`${fixture.url}/trust/`);
    await page.getByRole("heading", { name: "This server serves no network" }).waitFor();
    expect(await page.getByText("race serve --lan").isVisible()).toBe(true);
    expect(await page.getByRole("link", { name: "Download the certificate" }).isVisible()).toBe(false);
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("trust-none");
  });

  it("is asked again while it does not answer", async () => {
    const { page } = fixture;
    await page.goto(`${fixture.url}/trust/`);
    await fixture.kill();
    fixture.allowError(/ERR_CONNECTION_REFUSED/);
    // The page was loaded before.
    await page.route("**/trust/", (route) => route.abort());
    await page.evaluate(() => document.getElementById("retry")?.click());
    await page.getByRole("heading", { name: "The server does not answer" }).waitFor();
    await fixture.screenshot("trust-lost");
    expect(await findings(page)).toEqual([]);
    await fixture.restart();
    await page.getByRole("heading", { name: "This server serves no network" }).waitFor();
  });
});

describe.skipIf(host === undefined)("a server that a network reaches", () => {
  let fixture: Fixture;
  let lan: string;
  beforeAll(async () => {
    const port = await freePort();
    lan = `https://${host ?? ""}:${port}`;
    const account = (data: string) => void execFileSync(binary, ["account", "add", "ada", "--role", "admin", "--data", data], { input: `${kPassword}\n` });
    fixture = await openPrepared(account, "--lan", "--lan-port", String(port));
  });
  afterAll(() => fixture.close());

  async function open(options: BrowserContextOptions, path: string, at = lan): Promise<Page> {
    const page = await (await fixture.openContext({ ...options, ignoreHTTPSErrors: true })).newPage();
    page.setDefaultTimeout(kPatience);
    await page.goto(`${at}${path}`);
    return page;
  }

  it("shows a phone its fingerprint and the steps of its system, without a login", async () => {
    const page = await open(kPhone, "/trust/");
    const shown = page.getByLabel("Fingerprint, SHA-256");
    await shown.waitFor();
    const answer = await fetch(`${fixture.url}/api/v1/authority`);
    const fingerprint = answer.headers.get("x-fingerprint-sha256") ?? "";
    expect(fingerprint).toMatch(/^(?:[0-9A-F]{2}:){31}[0-9A-F]{2}$/);
    await expect.poll(async () => (await shown.innerText()).trim().split(/\s+/).join(":"), kSoon).toBe(fingerprint);
    await expect.poll(() => openSections(page), kSoon).toEqual(["Android"]);
    expect(await findings(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
    await expect.poll(() => new URL(page.url()).hash, kSoon).toBe("");
    await fixture.screenshot("trust-phone", page);
    await page.context().close();
  });

  const stopped = async () => ((await fixture.send("GET", "/control")) as { readonly stopped: object | null }).stopped !== null;
  async function reset(): Promise<void> {
    const { token } = (await fixture.send("POST", "/login", { name: "ada", password: kPassword })) as { readonly token: string };
    const answer = await fetch(`${fixture.url}/api/v1/stop/reset`, { method: "POST", headers: { authorization: `Bearer ${token}` } });
    expect(answer.status).toBe(200);
  }

  it("stops the cell from a phone that does not trust the server yet, without a login, and says so", async () => {
    const page = await open(kPhone, "/trust/");
    await page.getByLabel("Fingerprint, SHA-256").waitFor();
    expect((await stopButton(page).boundingBox())?.height).toBeGreaterThanOrEqual(64);
    expect(await banner(page).count(), "the cell is free").toBe(0);
    await page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight));
    const [end, bar] = [await page.getByText("It says nothing about who you are").boundingBox(), await page.locator("#stop-layer").boundingBox()];
    expect((end?.y ?? 0) + (end?.height ?? 0), "it covers nothing").toBeLessThanOrEqual(bar?.y ?? 0);
    await stopButton(page).tap();
    await expect.poll(stopped, kSoon).toBe(true);
    await expect.poll(() => banner(page).innerText(), kSoon).toMatch(/^STOPPED by somebody at \d\d:\d\d:\d\d\s+All runs have ended\. Nothing moves until the reset/);
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("trust-stopped-phone", page);
    await reset();
    await banner(page).waitFor({ state: "hidden" });
    await page.context().close();
  });

  it("stops the cell by the ordinary port alone, as a phone sends nothing to a port of which it was not told", async () => {
    const page = await open(kPhone, "/trust/", fixture.url); // at an IPv6 address, pages know no other port
    fixture.allowError(/ERR_ADDRESS_UNREACHABLE .*\/api\/v1\/stop\)/);
    let tries = 0;
    await page.route((url) => url.pathname === "/api/v1/stop" && url.origin !== fixture.url, (route) => {
      tries++;
      return route.abort("addressunreachable");
    });
    await page.getByLabel("Fingerprint, SHA-256").waitFor();
    await expect.poll(async () => {
      if (await stopped()) await reset();
      await stopButton(page).tap();
      await banner(page).waitFor();
      return tries;
    }, kSoon).toBeGreaterThan(0);
    expect(await stopped()).toBe(true);
    await reset();
    await page.context().close();
  });

  it("is stopped by the key, and STOP covers nothing in windows of any width", async () => {
    const page = await open({ viewport: { width: 1366, height: 768 } }, "/trust/");
    await page.getByLabel("Fingerprint, SHA-256").waitFor();
    for (const width of [761, 800, 960, 1000, 1001, 1100, 1366]) {
      await page.setViewportSize({ width, height: 768 });
      const right = () => page.locator("main > div, main > header").evaluateAll((parts) => Math.max(...parts.map((part) => part.getBoundingClientRect().right)));
      await expect.poll(async () => (await right()) - ((await stopButton(page).boundingBox())?.x ?? 0), { ...kSoon, message: String(width) }).toBeLessThanOrEqual(0);
    }
    await page.keyboard.press("F3");
    await expect.poll(stopped, kSoon).toBe(true);
    await banner(page).waitFor();
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("trust-stopped-1366", page);
    await reset();
    await page.context().close();
  });

  it("is small: its scripts are what it uses, and no library", async () => {
    const page = await open(kPhone, "/trust/");
    await page.getByLabel("Fingerprint, SHA-256").waitFor();
    const bytes = await page.evaluate(() =>
      performance.getEntriesByType("resource").filter(({ name }) => name.endsWith(".js")).reduce((sum, entry) => sum + (entry as PerformanceResourceTiming).decodedBodySize, 0),
    );
    console.log(`scripts of /trust/: ${bytes} bytes`);
    expect(bytes).toBeGreaterThan(1000);
    expect(bytes).toBeLessThan(32_000);
    await page.context().close();
  });

  it("gives the certificate of the authority", async () => {
    const page = await open(kPhone, "/trust/");
    const loaded = page.waitForEvent("download");
    await page.getByRole("link", { name: "Download the certificate" }).click();
    expect((await loaded).suggestedFilename()).toBe("race-authority.crt");
    await page.context().close();
  });

  it("opens the section that the address names, and writes the chosen one there", async () => {
    const page = await open(kPhone, "/trust/#windows");
    await expect.poll(() => openSections(page), kSoon).toEqual(["Windows"]);
    await page.locator("summary", { hasText: "macOS" }).focus();
    await page.keyboard.press("Enter");
    await expect.poll(() => openSections(page), kSoon).toEqual(["macOS"]);
    await expect.poll(() => new URL(page.url()).hash, kSoon).toBe("#macos");
    await expect.poll(() => section(page, "macOS").getByText("Always Trust").isVisible(), kSoon).toBe(true);
    await page.reload();
    await expect.poll(() => openSections(page), kSoon).toEqual(["macOS"]);
    await page.context().close();
  });

  it.each([
    { name: "laptop", viewport: { width: 1366, height: 768 }, colorScheme: "light" },
    { name: "laptop-dark", viewport: { width: 1366, height: 768 }, colorScheme: "dark" },
    { name: "large", viewport: { width: 2560, height: 1440 }, colorScheme: "light" },
    { name: "phone-dark", viewport: { width: 390, height: 844 }, colorScheme: "dark" },
  ] as const)("has no findings: $name", async ({ name, ...options }) => {
    const page = await open(options, "/trust/#linux");
    await page.getByLabel("Fingerprint, SHA-256").waitFor();
    expect(await findings(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
    expect(await page.getByLabel("Fingerprint, SHA-256").evaluate((box) => box.scrollWidth - box.clientWidth)).toBeLessThanOrEqual(0);
    await fixture.screenshot(`trust-${name}`, page);
    await page.context().close();
  });

  it("leads to the page on trust from its logins, where they came over TLS", async () => {
    const link = (page: Page) => page.getByRole("link", { name: "Let this device trust it" });
    const display = await open(kPhone, "/display/?name=phone1");
    expect(await link(display).getAttribute("href")).toBe("/trust/");
    expect(await findings(display)).toEqual([]);
    await fixture.screenshot("trust-display-login", display);
    const pro = await open({ viewport: { width: 1366, height: 768 } }, "/pro/");
    await link(pro).waitFor();
    expect(await findings(pro)).toEqual([]);
    await fixture.screenshot("trust-pro-login", pro);
    const here = await open({}, "/pro/", fixture.url);
    await here.getByRole("dialog", { name: "Log in to RACE" }).waitFor();
    expect(await link(here).count()).toBe(0);
    for (const page of [display, pro, here]) await page.context().close();
  });

  it("is what a phone is told to trust when it is paired", async () => {
    const page = await open({ viewport: { width: 1366, height: 768 } }, "/pro/");
    await page.getByLabel("Name", { exact: true }).fill("ada");
    await page.getByLabel("Password", { exact: true }).fill(kPassword);
    await page.keyboard.press("Enter");
    await page.getByRole("button", { name: "Show the code" }).click();
    const dialog = page.getByRole("dialog", { name: "Pair a phone" });
    await dialog.getByText("Details", { exact: true }).click();
    await expect.poll(() => dialog.getByRole("link", { name: `${lan}/trust/` }).isVisible(), kSoon).toBe(true);
    await dialog.getByRole("img", { name: `QR code of ${lan}/display/?name=phone1` }).waitFor();
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("trust-pairing", page);
    await page.context().close();
  });
});
