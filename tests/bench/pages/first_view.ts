// When a page for people at the cell is first of use: from its address to the frame that shows what a hand looks for, by the page's own clock.
import { devices, type Browser, type BrowserContextOptions } from "playwright-core";

export interface FirstView {
  readonly name: string;
  readonly path: string;
  readonly device: BrowserContextOptions;
  /** A selector of what is looked for. */
  readonly shown: string;
}

export const kFirstViews: readonly FirstView[] = [
  { name: "a phone, what the display shows", path: "/display/?name=phone1#show", device: devices["Pixel 7"] ?? {}, shown: "main" },
  { name: "a phone, the teach pendant", path: "/display/?name=phone1#move/joints", device: devices["Pixel 7"] ?? {}, shown: '[aria-label="Joint 1 plus, while held"]' },
  { name: "a tablet, RACE-One", path: "/one/", device: devices["iPad (gen 7)"] ?? {}, shown: "main button" },
];

/** A phone of some years ago in a workshop's network: its processor, against this one, and its network. */
export const kSlow = { processor: 4, latency: 40, bytesPerSecond: 10e6 / 8 };

/** [ms], of a first visit, on this machine or as a slow phone would. */
export async function firstView(browser: Browser, url: string, { path, device, shown }: FirstView, isSlow: boolean): Promise<number> {
  const context = await browser.newContext({ ...device, serviceWorkers: "block" });
  try {
    const page = await context.newPage();
    if (isSlow) {
      const session = await context.newCDPSession(page);
      await session.send("Network.enable");
      await session.send("Network.emulateNetworkConditions", { offline: false, latency: kSlow.latency, downloadThroughput: kSlow.bytesPerSecond, uploadThroughput: kSlow.bytesPerSecond });
      await session.send("Emulation.setCPUThrottlingRate", { rate: kSlow.processor });
    }
    await page.addInitScript((selector) => {
      const look = (): void => {
        if (document.querySelector(selector) === null) requestAnimationFrame(look);
        else requestAnimationFrame(() => Object.assign(window, { benchShown: performance.now() }));
      };
      requestAnimationFrame(look);
    }, shown);
    await page.goto(`${url}${path}`);
    const found = await page.waitForFunction(() => (window as unknown as { readonly benchShown?: number }).benchShown, undefined, { timeout: 60_000 });
    return (await found.jsonValue()) ?? NaN;
  } finally {
    await context.close();
  }
}
