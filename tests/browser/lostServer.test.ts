// A network that says nothing any more: no connection ends, and no request is answered. Each page says so within some seconds, and comes back by itself.
import type { Page } from "playwright-core";
import { openFixture, type Fixture } from "./fixture";
import { openNetwork, type Network } from "./network";
import { holding } from "./prepare";
import { kPatience } from "./patience";

let fixture: Fixture;
let network: Network;
beforeAll(async () => {
  fixture = await openFixture();
  network = await openNetwork(fixture.url);
  // Questions without an answer are given up.
  fixture.allowError(/net::ERR_|WebSocket connection to/);
});
afterAll(async () => {
  network.close();
  await fixture.close();
});

/** Until the page is certain [ms], on a machine that has other things to do, too. */
const kSoon = { timeout: 12_000 };
const kPages = { pro: "/pro/?below=manual", one: "/one/" } as const;

const lost = (page: Page) => page.getByRole("alert", { name: "Server lost" });
const connection = (page: Page, text: RegExp) => page.getByRole("status").filter({ hasText: text }).first();
const holder = async () => ((await fixture.send("GET", "/control")) as { readonly holder: unknown }).holder;
const take = (page: Page) => page.getByRole("button", { name: "Take the controls" }).first();

async function open(name: keyof typeof kPages): Promise<Page> {
  const page = await (await fixture.openContext({ viewport: { width: 1366, height: 768 }, reducedMotion: "reduce" })).newPage();
  page.setDefaultTimeout(kPatience);
  await page.goto(`${network.url}${kPages[name]}`);
  await connection(page, /Connected/).waitFor();
  // What draws it may keep a page without a GPU from its signs of life.
  const close = page.getByRole("button", { name: "Close the cell view" });
  if (await close.isVisible()) await close.click();
  return page;
}

describe.each(["pro", "one"] as const)("a silent network of the page %s", (name) => {
  let page: Page;
  beforeAll(async () => void (page = await open(name)));
  afterAll(async () => {
    network.restore();
    await page.context().close();
  });

  it("is said, and the controls are given back", async () => {
    const mark = page.getByText("You have the controls", { exact: true }).first();
    const taken = async () => {
      await take(page).click();
      // The page knows it, too.
      await mark.waitFor();
    };
    await holding(taken, mark, () => expect.poll(holder, { timeout: 2000 }).not.toBeNull());
    network.lose();
    await lost(page).waitFor(kSoon);
    await fixture.screenshot(`lost-server-${name}`, page);
    await page.getByRole("alert").filter({ hasText: "You have LOST the controls" }).waitFor();
    await expect.poll(holder).toBeNull();
  });

  it("is said until it answers again, and then no more, without a hand", async () => {
    await page.waitForTimeout(6000);
    expect(await lost(page).count()).toBe(1);
    network.restore();
    await lost(page).waitFor({ state: "detached", ...kSoon });
    await connection(page, /Connected/).waitFor();
    // It does not take the controls by itself.
    expect(await holder()).toBeNull();
  });

  it("is not said of a page whose thread was busy for longer", async () => {
    const told = page.evaluate(
      () =>
        new Promise<number>((resolve) => {
          let count = 0;
          const observer = new MutationObserver(() => (count += document.querySelectorAll('[role="alert"][aria-label="Server lost"]').length));
          observer.observe(document.body, { childList: true, subtree: true });
          setTimeout(() => {
            observer.disconnect();
            resolve(count);
          }, 12_000);
          const busy = (left: number): void => {
            for (const end = performance.now() + 2500; performance.now() < end; );
            if (left > 0) setTimeout(() => busy(left - 1), 50);
          };
          busy(2);
        }),
    );
    expect(await told).toBe(0);
  });
});
