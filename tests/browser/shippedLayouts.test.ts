// The first visit to the demo needs no layout engine: its layouts come with the pages. RACE_KEEP_LAYOUTS=1 makes web/pro/canvas/shippedLayouts.json
// anew, of windows of every shape; needed when the demo, the sizes of texts, ELK or what it is given have changed.
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { openFixture, project, settled, type Fixture } from "./fixture";
import { kSoon } from "./patience";

const kKeeps = process.env["RACE_KEEP_LAYOUTS"] === "1";
const kFile = join(project, "web/pro/canvas/shippedLayouts.json");
const kChecked = [[1366, 768], [390, 844]] as const;
const kKept = [...kChecked, [2560, 1440], [1280, 800], [1440, 900], [1536, 864], [1600, 1000], [1920, 1080], [1024, 768], [820, 1180]] as const;

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
});
afterAll(() => fixture.close());

const runOf = async (document: string) => `/pro/?run=${((await fixture.send("POST", "/cores", { document })) as { readonly id: string }).id}`;
/** The page that a new user sees, and, as soon as there are runs, the others. */
const kStages: Readonly<Record<string, () => Promise<readonly string[]>>> = {
  "the start page": () => Promise.resolve(["/pro/"]),
  "the demo": async () => [await runOf("pick"), await runOf("demonstrator"), "/pro/?edit=pick"],
};

/** Key and layout of all that a browser keeps: the key says the version of ELK, too. */
type Kept = readonly (readonly [key: string, layout: { readonly graph: string; readonly answer: string }])[];

const kept = (page: Page): Promise<Kept> =>
  page.evaluate(async () => {
    const done = <T>(request: IDBRequest<T>) => new Promise<T>((resolve, reject) => {
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => reject(request.error ?? new Error("IndexedDB"));
    });
    const store = (await done(indexedDB.open("race-layouts"))).transaction("layouts").objectStore("layouts");
    const [keys, all] = [await done(store.getAllKeys()), await done(store.getAll())];
    return keys.map((key, i) => [typeof key === "string" ? key : "", all[i]] as const);
  });

async function visit(page: Page, address: string): Promise<void> {
  await page.goto(`${fixture.url}${address}`);
  if (address === "/pro/") await page.locator(".start-picture svg").nth(2).waitFor(kSoon);
  else await settled(page);
}

const usesEngine = (page: Page): Promise<boolean> => page.evaluate(() => performance.getEntriesByType("resource").some(({ name }) => name.includes("elk-worker")));

describe.skipIf(kKeeps).each(Object.entries(kStages))("the first visit of %s", (_, addresses) => {
  let all: readonly string[] = [];
  beforeAll(async () => {
    all = await addresses();
  });
  it.each(kChecked)("lays nothing out in a window of %s by %s", async (width, height) => {
    for (const address of all) {
      const page = await (await fixture.openContext({ viewport: { width, height } })).newPage();
      await visit(page, address);
      expect(await usesEngine(page), address).toBe(false);
      await page.context().close();
    }
  });
});

it.runIf(kKeeps)("is prepared", async () => {
  const all: Record<string, Kept[number][1]> = {};
  let elk = "";
  for (const addresses of Object.values(kStages)) {
    const these = await addresses();
    for (const [width, height] of kKept) {
      const page = await (await fixture.openContext({ viewport: { width, height } })).newPage();
      for (const address of these) {
        await visit(page, address);
        await page.waitForTimeout(1000); // What is kept is kept a little later.
      }
      for (const [key, layout] of await kept(page)) {
        const [version = "", short = ""] = key.split(" ");
        elk = version;
        all[short] = layout;
      }
      await page.context().close();
    }
  }
  const layouts = Object.fromEntries(Object.entries(all).sort(([a], [b]) => a.localeCompare(b)));
  writeFileSync(kFile, `${JSON.stringify({ elk, layouts })}\n`);
}, 600_000);
