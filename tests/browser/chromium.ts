// Chromium for the browser tests: one for all files, as it starts slowly. A file has contexts of its own, which end with its connection.
import { chromium, type Browser, type LaunchOptions } from "playwright-core";

/** The tests run without network, GPU and screen. */
const options: LaunchOptions = {
  executablePath: process.env["CHROMIUM"] ?? "/usr/bin/chromium",
  args: [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-dev-shm-usage",
  ],
};

/** Where the files of a run find their Chromium. */
const kShared = "RACE_CHROMIUM_SERVER";

/** Vitest calls it once, before the first file; what it gives is called after the last one. */
export async function setup(): Promise<() => Promise<void>> {
  const server = await chromium.launchServer(options);
  process.env[kShared] = server.wsEndpoint();
  return () => server.close();
}

/** The Chromium of the run; a new one where there is none. */
export function openBrowser(): Promise<Browser> {
  const shared = process.env[kShared];
  return shared === undefined ? chromium.launch(options) : chromium.connect(shared);
}
