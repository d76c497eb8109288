// deploy/bench pages: how fast the expert page opens, moves and edits a document of 2000 states, measured by the browser on the real
// server; beside each figure its goal. Prints a table; the load of the machine is said, as figures of a busy one are worse.
import { loadavg } from "node:os";
import type { Page } from "playwright-core";
import { openFixture, web, type Fixture } from "../../browser/fixture";
import { bundleSize } from "./bundle";
import { firstView, kFirstViews, kSlow } from "./first_view";
import { largeDocument } from "./large_document.mjs";
import { pan, zoom } from "./motion";
import { installProbe, openingOf, type Region } from "./probe";
import { frameWorkDuring, quantile } from "./work";

const kChanges = 200;
/** A movement is measured for so long [s]. */
const kSeconds = 6;

function say(what: string, figure: string, goal = ""): void {
  console.log(`${what.padEnd(66)}${figure.padStart(18)}${goal === "" ? "" : `   goal ${goal}`}`);
}

const ms = (value: number): string => `${Math.round(value)} ms`;

/** The document as it is at first: a part may have edited it. */
const putLarge = (fixture: Fixture): Promise<unknown> => fixture.send("PUT", "/documents/large", largeDocument(kChanges));

async function opened(fixture: Fixture, path: string, viewport = { width: 1600, height: 1000 }): Promise<Page> {
  const context = await fixture.page.context().browser()?.newContext({ viewport });
  if (context === undefined) throw new Error("there is no browser");
  const page = await context.newPage();
  page.on("pageerror", (error) => console.error(error));
  await installProbe(page);
  await page.goto(`${fixture.url}${path}`);
  return page;
}

async function sayOpening(what: string, page: Page, goal: string): Promise<void> {
  const { drawn, usable, work } = await openingOf(page);
  say(`${what}: drawn`, ms(drawn), goal);
  say(`${what}: work of the main thread for that (processor time)`, ms(work));
  say(`${what}: drawn, and no long task follows`, ms(usable), goal);
}

async function sayMovement(page: Page, how: string): Promise<void> {
  for (const [name, move] of [["pan", pan], ["zoom", zoom]] as const) {
    const { framesPerSecond, late, mean, most95 } = await frameWorkDuring(page, () => move(page, kSeconds));
    say(`${name}, ${how}: frames a second`, `${framesPerSecond.toFixed(1)} (${Math.round(late * 100)} % late)`, ">= 30");
    say(`${name}, ${how}: main-thread work of a frame, mean (95 %)`, `${mean.toFixed(1)} (${most95.toFixed(1)}) ms`, "<= 8 ms");
  }
}

/** The most elements that the page has, from the whole drawing to the largest zoom. */
async function sayElements(page: Page, how: string): Promise<void> {
  const counts: number[] = [];
  await page.keyboard.press("Control+0");
  const box = await page.locator(".painted").boundingBox();
  await page.mouse.move((box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2);
  for (let step = 0; step < 18; step++) {
    await page.mouse.wheel(0, step === 0 ? 0 : -150);
    await page.waitForTimeout(350);
    counts.push(await page.locator("body *").count());
  }
  say(`elements of the page, ${how}: most of any zoom`, String(Math.max(...counts)), "<= 300");
}

/** Selects a state of the first composite and presses a key that edits it: from the key to the frame that shows the change. */
async function edit(page: Page, path: string, key: string): Promise<number> {
  await page.getByRole("tree", { name: "State tree" }).getByRole("treeitem", { name: path, exact: true }).getByRole("button").click();
  const drawn = page.locator(`.painted .is-selected[data-path="${path}"]`);
  await drawn.waitFor();
  await drawn.locator(".state-name").focus();
  // The view comes to rest there, and is painted.
  await page.waitForTimeout(1200);
  const box = await drawn.boundingBox();
  if (box === null) throw new Error(`${path} is not shown`);
  const region: Region = { x: box.x, y: box.y, width: box.width, height: box.height };
  await page.evaluate((at) => void Object.assign(window, { benchEdit: window.benchProbe.untilChanged(at) }), region);
  await page.keyboard.press(key);
  return page.evaluate(() => (window as unknown as { readonly benchEdit: Promise<number> }).benchEdit);
}

async function sayEdits(page: Page): Promise<void> {
  const steps = Array.from({ length: 9 }, (_, i) => `Large/Group1/Part1/Step${i + 1}`);
  const [first = 0, ...more] = await inTurn(steps, (path) => edit(page, path, "Control+ArrowDown"));
  say("an edit, key to pixels: the first, a state is moved", ms(first), "< 200 ms");
  say("an edit, key to pixels: further moves, median (most)", `${Math.round(quantile(more, 0.5))} (${Math.round(Math.max(...more))}) ms`, "< 200 ms");
  const removals = await inTurn(steps.slice(4), (path) => edit(page, path, "Delete"));
  say("an edit, key to pixels: a state is deleted, median (most)", `${Math.round(quantile(removals, 0.5))} (${Math.round(Math.max(...removals))}) ms`, "< 200 ms");
}

async function inTurn<T>(items: readonly T[], measure: (item: T) => Promise<number>): Promise<readonly number[]> {
  const figures: number[] = [];
  for (const item of items) figures.push(await measure(item));
  return figures;
}

function sayBundle(): void {
  const { gzip, brotli } = bundleSize(web, "pro/index.html");
  say("scripts and styles of the expert page, brotli (gzip)", `${Math.round(brotli / 1000)} (${Math.round(gzip / 1000)}) kB`, "<= 500 kB");
}

async function sayFirstPage(fixture: Fixture): Promise<void> {
  const { id } = (await fixture.send("POST", "/cores", { document: "pick" })) as { readonly id: string };
  for (const time of ["first visit", "first visit of another browser"]) {
    const page = await opened(fixture, `/pro/?run=${id}`);
    await sayOpening(`the demo (pick), ${time}`, page, "<= 1500 ms");
    const bytes = await page.evaluate(() => performance.getEntriesByType("resource").reduce((sum, entry) => sum + (entry as PerformanceResourceTiming).encodedBodySize, 0));
    say("all that was sent for it, with fonts, layout and data", `${Math.round(bytes / 1000)} kB`);
    await page.reload();
    await sayOpening(`the demo (pick), again after the ${time}`, page, "<= 1500 ms");
    await page.context().close();
  }
}

/** The demo as a newcomer watches it on a large screen: the task, its derivation and the cell in which the arm moves. */
async function sayDemo(fixture: Fixture): Promise<void> {
  const { id } = (await fixture.send("POST", "/cores", { document: "pick" })) as { readonly id: string };
  const page = await opened(fixture, `/pro/?run=${id}`, { width: 1920, height: 1080 });
  await openingOf(page);
  await page.getByText(/^cell time/).waitFor();
  await fixture.send("POST", `/cores/${id}/start`);
  const { framesPerSecond, late, mean, most95 } = await frameWorkDuring(page, () => page.waitForTimeout(kSeconds * 1000));
  say("the demo runs, derivation and cell shown, 1920 x 1080: frames", `${framesPerSecond.toFixed(1)} (${Math.round(late * 100)} % late)`, ">= 30");
  say("the demo runs: main-thread work of a frame, mean (95 %)", `${mean.toFixed(1)} (${most95.toFixed(1)}) ms`);
  await page.context().close();
}

async function sayEditor(fixture: Fixture): Promise<void> {
  await putLarge(fixture);
  const page = await opened(fixture, "/pro/?edit=large");
  await sayOpening("2000 states, to edit", page, "<= 2000 ms");
  await sayMovement(page, "to edit");
  await sayElements(page, "to edit");
  await sayEdits(page);
  await page.close();
}

async function sayRun(fixture: Fixture): Promise<void> {
  await putLarge(fixture);
  const { id } = (await fixture.send("POST", "/cores", { document: "large" })) as { readonly id: string };
  const page = await opened(fixture, `/pro/?run=${id}`);
  await sayOpening("2000 states, a run, folded", page, "<= 2000 ms");
  const begin = performance.now();
  await page.getByRole("button", { name: "Expand all" }).click();
  await page.locator('.canvas[aria-busy="false"] .painted').waitFor({ timeout: 120_000 });
  say("2000 states, a run: all unfolded", ms(performance.now() - begin));
  await fixture.send("POST", `/cores/${id}/start`);
  const stepOf = async () => ((await fixture.send("GET", `/cores/${id}`)) as { readonly step: number }).step;
  await page.waitForTimeout(2000);
  const [before, started] = [await stepOf(), performance.now()];
  await sayMovement(page, `${kChanges} changes a second, derivation open`);
  await page.getByRole("tab", { name: "Derivation" }).click();
  await page.getByRole("region", { name: "Derivation" }).waitFor({ state: "detached" });
  await sayMovement(page, `${kChanges} changes a second`);
  say("macro steps of the run a second, meanwhile", String(Math.round(((await stepOf()) - before) / ((performance.now() - started) / 1000))));
  await sayElements(page, `${kChanges} changes a second`);
  await fixture.send("POST", `/cores/${id}/stop`);
  await page.close();
}

/** The pages for people at the cell. */
async function sayFirstViews(fixture: Fixture): Promise<void> {
  const browser = fixture.page.context().browser();
  if (browser === null) throw new Error("there is no browser");
  console.log(`slow: a processor ${kSlow.processor} times slower, and ${kSlow.bytesPerSecond * 8e-6} Mbit/s with ${kSlow.latency} ms`);
  for (const view of kFirstViews)
    for (const isSlow of [false, true]) {
      const times = await inTurn([...Array(9).keys()], () => firstView(browser, fixture.url, view, isSlow));
      say(`${view.name}${isSlow ? ", slow" : ""}: first view, median (most) of ${times.length}`, `${Math.round(quantile(times, 0.5))} (${Math.round(Math.max(...times))}) ms`, "<= 1500 ms");
    }
}

const parts: Readonly<Record<string, (fixture: Fixture) => Promise<void>>> = { first: sayFirstPage, views: sayFirstViews, demo: sayDemo, edit: sayEditor, run: sayRun };

const wanted = process.argv.slice(2).filter((name) => name in parts);
const fixture = await openFixture();
try {
  console.log(`load of the machine before: ${loadavg().map((load) => load.toFixed(1)).join(" ")}`);
  sayBundle();
  for (const name of wanted.length > 0 ? wanted : Object.keys(parts)) await parts[name]?.(fixture);
  console.log(`load of the machine after: ${loadavg().map((load) => load.toFixed(1)).join(" ")}`);
} finally {
  await fixture.close();
}
