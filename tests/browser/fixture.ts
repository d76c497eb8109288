// The fixture of a browser test: its own server on a free port, and a page in Chromium.
import { spawn, type ChildProcess } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Browser, BrowserContext, BrowserContextOptions, Download, Page, ViewportSize } from "playwright-core";
import { openBrowser } from "./chromium";
import { ConsoleErrors } from "./consoleErrors";

export const project = fileURLToPath(new URL("../../", import.meta.url));
export const binary = process.env["RACE_BINARY"] ?? join(project, "build/release/race");
export const demo = process.env["RACE_DEMO"] ?? join(project, "deploy/demo");
/** The built pages. */
export const web = process.env["RACE_WEB"] ?? join(project, "web/dist");
const screenshots = join(project, "build/test/browser");

export interface Fixture {
  readonly url: string;
  /** The data folder of the server. */
  readonly data: string;
  readonly page: Page;
  /** A request to `/api/v1` + path, and the JSON of its answer; a refusal is an error. */
  readonly send: (method: string, path: string, body?: unknown) => Promise<unknown>;
  /** Writes build/test/browser/NAME.png. */
  readonly screenshot: (name: string, of?: Page) => Promise<void>;
  /** A second browser window on the expert page, of this size if it is given [px]. */
  readonly openPage: (size?: ViewportSize) => Promise<Page>;
  /** Another browser, as it were: of a phone, or with other preferences. */
  readonly openContext: (options: BrowserContextOptions) => Promise<BrowserContext>;
  /** Allows errors on the consoles of pages (`TEXT (URL)`) that a test provokes, from now on; any other fails the test file. */
  readonly allowError: (error: RegExp) => void;
  /** Of the process of the server. */
  readonly pid: () => number;
  /** Ends the server by SIGKILL. */
  readonly kill: () => Promise<void>;
  /** Ends it as a service manager does, by SIGTERM. */
  readonly terminate: () => Promise<void>;
  /** Starts a server on the same port with the same data. */
  readonly restart: () => Promise<void>;
  /** Throws if there was an error on the console of a page. */
  readonly close: () => Promise<void>;
}

/** Below those that a system gives to connections: one of these would have the port before the server has it, or while that is started again. */
const kPorts = { first: 20_000, count: 10_000 };

/** A port that nothing listens on now. */
export function freePort(): Promise<number> {
  const port = kPorts.first + Math.floor(Math.random() * kPorts.count);
  return new Promise((resolve) => {
    const probe = createServer();
    probe.once("error", () => resolve(freePort()));
    probe.listen(port, "127.0.0.1", () => probe.close(() => resolve(port)));
  });
}

async function healthy(url: string, server: ChildProcess): Promise<void> {
  for (;;) {
    if (server.exitCode !== null) throw new Error(`the server ended with status ${server.exitCode}`);
    const answer = await fetch(`${url}/api/v1/health`).catch(() => undefined);
    if (answer?.ok === true) return;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}

/** Starts `race serve` with these `further` options; `--demo` names another folder of the cell. */
export const openFixture = (...further: readonly string[]): Promise<Fixture> => openPrepared(() => undefined, ...further);

/** The same on a data folder that is prepared before. */
export async function openPrepared(prepare: (data: string) => void, ...further: readonly string[]): Promise<Fixture> {
  const port = await freePort();
  // In memory: a disk that is busy with something else would interrupt runs.
  const data = mkdtempSync(join(existsSync("/dev/shm") ? "/dev/shm" : tmpdir(), "race-browser-"));
  const options = ["serve", "--port", String(port), "--data", data, ...(further.includes("--demo") ? [] : ["--demo", demo]), "--web", web, ...further];
  const launch = async (): Promise<ChildProcess> => {
    const launched = spawn(binary, options, { stdio: ["ignore", "ignore", "inherit"] });
    await new Promise((resolve, reject) => launched.once("spawn", resolve).once("error", reject));
    return launched;
  };
  prepare(data);
  let server = await launch();
  let browser: Browser | undefined;
  const end = async (signal: NodeJS.Signals) => {
    const ended = new Promise((resolve) => server.once("exit", resolve));
    if (server.exitCode === null && server.signalCode === null && server.kill(signal)) await ended;
  };
  const errors = new ConsoleErrors();
  const clear = async () => {
    await browser?.close();
    await end("SIGTERM");
    rmSync(data, { recursive: true, force: true });
  };
  const close = async () => {
    await clear();
    errors.check();
  };
  const kill = () => {
    errors.allowLost();
    return end("SIGKILL");
  };
  const terminate = () => {
    errors.allowLost();
    return end("SIGTERM");
  };
  try {
    const url = `http://127.0.0.1:${port}`;
    await healthy(url, server);
    const opened = await openBrowser();
    browser = opened;
    const openContext = async (options: BrowserContextOptions) => {
      const context = await opened.newContext(options);
      errors.watch(context);
      return context;
    };
    const page = await (await openContext({ viewport: { width: 1600, height: 1000 } })).newPage();
    mkdirSync(screenshots, { recursive: true });
    const screenshot = async (name: string, of = page) => void (await of.screenshot({ path: join(screenshots, `${name}.png`) }));
    const openPage = async (size?: ViewportSize) => {
      const second = await (await openContext(size === undefined ? {} : { viewport: size })).newPage();
      await second.goto(`${url}/pro/`);
      return second;
    };
    const send = async (method: string, path: string, body?: unknown): Promise<unknown> => {
      const answer = await fetch(`${url}/api/v1${path}`, { method, body: body === undefined ? null : JSON.stringify(body), headers: { "content-type": "application/json" } });
      if (!answer.ok) throw new Error(`${path}: ${answer.status} ${await answer.text()}`);
      return answer.json();
    };
    const restart = async () => {
      server = await launch();
      await healthy(url, server);
    };
    const pid = () => {
      if (server.pid === undefined) throw new Error("there is no server");
      return server.pid;
    };
    return { url, data, page, send, screenshot, openPage, openContext, allowError: (error) => errors.allow(error), pid, kill, terminate, restart, close };
  } catch (error) {
    await clear();
    throw error;
  }
}

/** Waits until the page has drawn twice, so that what moves has moved; not for a page that is not seen. */
export const frames = (page: Page): Promise<void> =>
  page.evaluate(
    () =>
      new Promise<void>((resolve) => {
        requestAnimationFrame(() => requestAnimationFrame(() => resolve()));
        setTimeout(resolve, 1000);
      }),
  );

/** Waits until the drawing is final: a click on a drawing that is then replaced is lost. */
export async function settled(page: Page): Promise<void> {
  await page.locator('.canvas[aria-busy="false"]:has(.react-flow, .painted)').waitFor();
  // It moves to where it fits, from frame to frame, which may be slow.
  const place = async () => {
    await frames(page);
    return page.evaluate(() => JSON.stringify(document.querySelector(".canvas [data-path]")?.getBoundingClientRect()));
  };
  for (let [before, now] = ["", await place()]; before !== now; [before, now] = [now, await place()]) await page.waitForTimeout(60);
}

/** What a page has given to be saved. */
export async function textOf(download: Download): Promise<string> {
  const parts: Buffer[] = [];
  for await (const part of await download.createReadStream()) parts.push(part as Buffer);
  return Buffer.concat(parts).toString("utf8");
}
