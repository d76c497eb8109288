// The documents of the server, from the page: new, open, upload, drop, download, duplicate, delete; and drafts, whose errors are shown where they are.
import type { Locator, Page } from "playwright-core";
import { findings } from "./axe";
import { editPage } from "./editPage";
import { openFixture, settled, textOf, type Fixture } from "./fixture";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
  // Chromium reports an answer that refuses as an error of the page, too.
  fixture.allowError(/^Failed to load resource: the server responded with a status of 4/);
  await fixture.page.setViewportSize({ width: 1366, height: 768 });
  await fixture.page.goto(`${fixture.url}/pro/`);
});
afterAll(() => fixture.close());

const panelOf = (page: Page): Locator => page.getByRole("dialog", { name: "Documents" });
const panel = (): Locator => panelOf(fixture.page);
const row = (name: string, page = fixture.page): Locator => panelOf(page).getByRole("listitem", { name, exact: true });
const uploaded = (file: string): Locator => panel().getByRole("list", { name: "Uploads" }).getByRole("listitem", { name: file });
const node = (path: string): Locator => fixture.page.locator(`.react-flow [data-path="${path}"]`);
const names = async (): Promise<readonly string[]> => ((await fixture.send("GET", "/documents")) as { documents: { name: string }[] }).documents.map(({ name }) => name);

async function openPanel(page = fixture.page): Promise<void> {
  if (!(await panelOf(page).isVisible())) await page.getByRole("button", { name: "Documents" }).click();
  await panelOf(page).waitFor();
}

/** What is typed then is searched. */
async function openByKey(): Promise<void> {
  await fixture.page.keyboard.press("Control+o");
  await expect.poll(() => fixture.page.evaluate(() => document.activeElement?.getAttribute("aria-label"))).toBe("Search the documents");
}

/** What axe-core finds in the light and in the dark theme. */
async function inBothThemes(): Promise<readonly string[]> {
  const { page, screenshot } = fixture;
  await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
  const dark = await findings(page);
  await screenshot("documents-dark");
  await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
  return [...dark, ...(await findings(page))];
}

interface Dropped {
  readonly name: string;
  readonly text: string;
}

/** Drops files onto an element, as a file manager does. */
async function drop(target: Locator, files: readonly Dropped[]): Promise<void> {
  const dataTransfer = await fixture.page.evaluateHandle((all) => {
    const transfer = new DataTransfer();
    for (const { name, text } of all) transfer.items.add(new File([text], name, { type: "application/json" }));
    return transfer;
  }, files);
  for (const type of ["dragenter", "dragover"]) await target.dispatchEvent(type, { dataTransfer });
  await fixture.page.getByText("Drop files here").waitFor();
  await target.dispatchEvent("drop", { dataTransfer });
  await fixture.page.getByText("Drop files here").waitFor({ state: "hidden" });
}

async function downloaded(name: string): Promise<{ readonly file: string; readonly text: string }> {
  const saved = fixture.page.waitForEvent("download");
  await row(name).getByRole("button", { name: "Download" }).click();
  const download = await saved;
  return { file: download.suggestedFilename(), text: await textOf(download) };
}

/** Numbers that JavaScript would write in another way. */
const kExact = '{"rcm":1,"root":{"state":"Exact","variables":[{"name":"v","initial":1.0},{"name":"big","initial":9007199254740993}]}}';
/** It leads nowhere, and has a condition that is not whole. */
const kFaulty = JSON.stringify({ rcm: 1, root: { state: "Faulty", first: "Pick", children: [{ state: "Pick", ports: [{ name: "done", when: "1 +", to: "Place" }] }, { state: "Park" }], actions: [{ when: "True", do: "x = (" }] } });

describe("the documents", () => {
  it("are listed, searched and opened", async () => {
    const { page, screenshot } = fixture;
    await openPanel();
    await row("pick").getByText("revision 1").waitFor();
    await row("demonstrator").waitFor();
    await screenshot("documents-list");
    expect(await inBothThemes()).toEqual([]);
    await page.getByRole("searchbox", { name: "Search the documents" }).fill("nothing has this");
    await panel().getByText("No document has nothing has this").waitFor();
    await page.getByRole("searchbox", { name: "Search the documents" }).fill("POSE is in the database");
    await expect.poll(() => panel().locator(".document-name").allInnerTexts()).toEqual(["pick"]);
    await row("pick").getByRole("button", { name: "pick", exact: true }).click();
    await settled(page);
    await expect.poll(async () => [page.url().endsWith("?edit=pick"), await panel().count()]).toEqual([true, 0]);
  });

  it("are made by a name alone, by keyboard", async () => {
    const { page, send } = fixture;
    await openByKey();
    await page.keyboard.press("Tab");
    await page.keyboard.press("Enter");
    await page.keyboard.type("pick");
    await panel().getByText("There is a document pick.").waitFor();
    await expect.poll(() => panel().getByRole("button", { name: "Create" }).isDisabled()).toBe(true);
    await page.keyboard.type("-new");
    await page.keyboard.press("Enter");
    await node("pick_new").waitFor();
    expect(await send("GET", "/documents/pick-new")).toMatchObject({ revision: 1, errors: [], document: { root: { state: "pick_new" } } });
    await openByKey();
    await page.keyboard.type("pick-new");
    await page.keyboard.press("Escape");
    await panel().waitFor({ state: "hidden" });
    await openByKey();
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowUp");
    await expect.poll(() => page.evaluate(() => document.activeElement?.textContent)).toBe("demonstrator");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Enter");
    await settled(page);
    await expect.poll(() => page.url()).toContain("?edit=pick");
  });

  it("that the address names and that are not there can be made, or others be chosen", async () => {
    const { page, screenshot, url } = fixture;
    await page.goto(`${url}/pro/?edit=lost`);
    const missing = page.getByRole("region", { name: "No such document" });
    await missing.getByText("There is no document lost.").waitFor();
    expect(await page.getByText("there is no channel").count()).toBe(0);
    expect(await findings(page)).toEqual([]);
    await screenshot("documents-missing");
    await missing.getByRole("button", { name: "All documents" }).click();
    await panel().waitFor();
    await page.keyboard.press("Escape");
    await missing.getByRole("button", { name: "New document of this name" }).click();
    await node("lost").waitFor();
    expect(await missing.count()).toBe(0);
    expect(await names()).toContain("lost");
    await page.goto(`${url}/pro/?edit=no%20name`);
    await missing.getByText("A name is made of A-Z").waitFor();
    expect(await missing.getByRole("button", { name: "New document of this name" }).isDisabled()).toBe(true);
    await fixture.send("DELETE", "/documents/lost");
    await page.goto(`${url}/pro/`);
  });

  it("come from files as they are written, and go to files the same way", async () => {
    const { page } = fixture;
    await openPanel();
    await panel().locator("input[type=file]").setInputFiles([
      { name: "exact.rcm.json", mimeType: "application/json", buffer: Buffer.from(kExact) },
      { name: "other.json", mimeType: "application/json", buffer: Buffer.from('{"rcm":1,"root":{"state":"Other"}}') },
    ]);
    await uploaded("exact.rcm.json").getByText("Stored as exact, revision 1").waitFor();
    await uploaded("other.json").getByText("Stored as other, revision 1").waitFor();
    const { file, text } = await downloaded("exact");
    expect(file).toBe("exact.rcm.json");
    expect(text.replace(/,?"meta":\{"id":"\w+"\}/g, "")).toBe(kExact);
    // What was saved can be stored again: it is the same, so it stays the same revision.
    await panel().locator("input[type=file]").setInputFiles({ name: file, mimeType: "application/json", buffer: Buffer.from(text) });
    await uploaded(file).getByText("There is a document exact.").waitFor();
    await fixture.screenshot("documents-taken");
    await uploaded(file).getByRole("button", { name: "Replace exact, as revision 2" }).click();
    await uploaded(file).getByText("Stored as exact, revision 1").last().waitFor();
    for (const close of await panel().getByRole("button", { name: /^Close .*json/ }).all()) await close.page().getByRole("button", { name: /^Close .*json/ }).first().click();
    expect(await page.getByRole("list", { name: "Uploads" }).count()).toBe(0);
  });

  it("come as bundles, which say what they lack, and go as such", async () => {
    const { page } = fixture;
    const bundle = { bundle: 1, name: "flipping", document: { rcm: 1, services: { lamp: "lamp" }, root: { state: "Flip", entry: "svc.lamp.flip()" } } };
    await panel().locator("input[type=file]").setInputFiles([{ name: "flipping.bundle.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(bundle)) }]);
    await uploaded("flipping.bundle.json").getByText("Stored as flipping, revision 1, lacks 1 service").waitFor();
    expect(await page.getByRole("list", { name: "What flipping lacks" }).innerText()).toBe("lamp there is no service of this key here");
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("documents-bundle");
    const saved = page.waitForEvent("download");
    await row("flipping").getByRole("button", { name: "Bundle" }).click();
    const download = await saved;
    expect(download.suggestedFilename()).toBe("flipping.bundle.json");
    expect(JSON.parse(await textOf(download))).toMatchObject({ bundle: 1, name: "flipping", document: { root: { state: "Flip" } }, services: { lamp: { type: "lamp" } } });
    await panel().getByRole("button", { name: "Close flipping.bundle.json" }).click();
  });

  it("are taken from files that are dropped anywhere; of a taken name, as another or as the next revision", async () => {
    const { page, send } = fixture;
    await page.keyboard.press("Escape");
    const changed = kExact.replace('"Exact"', '"Changed"');
    await drop(page.locator("#workspace"), [{ name: "exact.json", text: changed }, { name: "far.json", text: '{"rcm":1,"root":{"state":"Far"}}' }]);
    await panel().waitFor();
    await uploaded("far.json").getByText("Stored as far, revision 1").waitFor();
    await uploaded("exact.json").getByRole("button", { name: "Replace exact, as revision 2" }).click();
    await uploaded("exact.json").getByText("Stored as exact, revision 2").waitFor();
    await drop(panel(), [{ name: "far.rcm.json", text: '{"rcm":1,"root":{"state":"Farther"}}' }]);
    await uploaded("far.rcm.json").getByRole("textbox", { name: "Store it as" }).fill("farther");
    await uploaded("far.rcm.json").getByRole("button", { name: "Store", exact: true }).click();
    await uploaded("far.rcm.json").getByText("Stored as farther, revision 1").waitFor();
    expect(await send("GET", "/documents/farther")).toMatchObject({ document: { root: { state: "Farther" } } });
  });

  it("are not made of a file that is none: the reason stays, and nothing else is lost", async () => {
    const before = await names();
    await drop(panel(), [{ name: "notes.txt", text: "no JSON" }, { name: "large.json", text: " ".repeat(4 * 1024 * 1024 + 1) }, { name: "shape.json", text: '{"rcm":1,"root":{"state":"R","first":3}}' }]);
    await uploaded("notes.txt").getByText("not JSON at byte").waitFor();
    await uploaded("large.json").getByText("the file has 4.1 MiB; the server takes at most 4 MiB").waitFor();
    const errors = uploaded("shape.json").getByRole("list").getByRole("listitem");
    await expect.poll(() => errors.allInnerTexts()).toEqual([expect.stringMatching(/^R .*first.* type$/)]);
    await fixture.screenshot("documents-refused");
    expect(await inBothThemes()).toEqual([]);
    expect(await names()).toEqual(before);
  });

  it("are duplicated and deleted, asked in the row; not while a run uses them", async () => {
    const { page, send } = fixture;
    await page.keyboard.press("Escape");
    await openPanel();
    await row("exact").getByRole("button", { name: "Duplicate" }).click();
    expect(await row("exact").getByRole("textbox").inputValue()).toBe("exact-2");
    await page.keyboard.press("Enter");
    await row("exact-2").waitFor();
    expect((await downloaded("exact-2")).text).toBe((await downloaded("exact")).text);
    await row("exact-2").getByRole("button", { name: "Delete" }).click();
    await page.keyboard.press("Escape");
    expect([await panel().count(), await row("exact-2").getByRole("group").count()], "Esc keeps the document, and the panel").toEqual([1, 0]);
    await row("exact-2").getByRole("button", { name: "Delete" }).click();
    await fixture.screenshot("documents-delete");
    expect(await inBothThemes()).toEqual([]);
    await row("exact-2").getByRole("button", { name: "Delete exact-2" }).click();
    await row("exact-2").waitFor({ state: "detached" });
    await expect.poll(() => names()).not.toContain("exact-2");

    await send("PUT", "/documents/waits", { rcm: 1, root: { state: "Waits", ports: [{ name: "never", when: "False" }] } });
    const { id } = (await send("POST", "/cores", { document: "waits", arguments: {} })) as { id: string };
    await send("POST", `/cores/${id}/start`, {});
    await page.evaluate(() => dispatchEvent(new Event("focus")));
    await row("waits").getByRole("button", { name: "Delete" }).click();
    await row("waits").getByRole("button", { name: "Delete waits" }).click();
    await row("waits").getByRole("alert").waitFor();
    await fixture.screenshot("documents-in-use");
    expect(await names()).toContain("waits");
    await send("POST", `/cores/${id}/stop`, {});
  });

  it("are the same in a second window, when it is looked at", async () => {
    const second = await fixture.openPage({ width: 1366, height: 768 });
    await openPanel(second);
    await row("far", second).waitFor();
    await row("far").getByRole("button", { name: "Delete" }).click();
    await row("far").getByRole("button", { name: "Delete far" }).click();
    await row("far").waitFor({ state: "detached" });
    await second.evaluate(() => dispatchEvent(new Event("focus")));
    await row("far", second).waitFor({ state: "detached" });
    await second.close();
  });
});

describe("a draft", () => {
  it("is stored on demand, opened, and its errors are listed and marked where they are", async () => {
    const { page, screenshot } = fixture;
    await openPanel();
    await drop(panel(), [{ name: "faulty.json", text: kFaulty }]);
    await uploaded("faulty.json").getByText("Not stored: 3 errors").waitFor();
    await uploaded("faulty.json").getByRole("button", { name: "Store as a draft" }).click();
    await uploaded("faulty.json").getByText("Stored as faulty, revision 1, a draft with 3 errors").waitFor();
    await expect.poll(() => row("faulty").getByRole("button", { name: "New run" }).isDisabled()).toBe(true);
    await uploaded("faulty.json").getByRole("button", { name: "Open" }).click();
    await settled(page);
    const errors = page.getByRole("region", { name: "Errors" }).locator("button.error-text");
    await expect.poll(() => errors.count()).toBe(3);
    await page.getByRole("button", { name: "Draft, 3 errors" }).waitFor();
    await expect.poll(() => node("Faulty/Pick").getAttribute("data-error")).toBe("2");
    await expect.poll(() => page.getByRole("button", { name: "Port Faulty/Pick.done" }).getAttribute("data-error")).toBe("2");
    await expect.poll(() => page.getByRole("treeitem", { name: "Faulty/Pick" }).getByRole("img", { name: "2 errors" }).count()).toBe(1);
    await errors.filter({ hasText: "Place" }).click();
    await page.locator(".port.is-selected").waitFor();
    await expect.poll(() => page.locator(".port.is-selected").getAttribute("aria-label")).toBe("Port Faulty/Pick.done");
    await screenshot("draft-1366");
    expect(await inBothThemes()).toEqual([]);
    await page.setViewportSize({ width: 1600, height: 1000 });
    await screenshot("draft-1600");
    await errors.filter({ hasText: "bracket" }).click();
    await page.locator('.state.is-selected[data-path="Faulty"]').waitFor();
  });

  it("cannot be started, and the key says why", async () => {
    const { page } = fixture;
    await page.keyboard.press("F5");
    const told = page.getByRole("log", { name: "Refused edits" });
    await told.getByText("faulty is a draft with 3 errors: it cannot be started").waitFor();
    await told.getByRole("button", { name: "Close" }).click();
  });

  it("is none any more when it is repaired, and can be run", async () => {
    const { page, send } = fixture;
    const { document } = (await send("GET", "/documents/faulty")) as { document: { root: { actions: { meta: { id: string } }[]; children: { ports?: { meta: { id: string } }[] }[] } } };
    const port = document.root.children[0]?.ports?.[0]?.meta.id ?? "";
    const action = document.root.actions[0]?.meta.id ?? "";
    const set = (id: string, field: string, value: string) => ({ op: "set", id, field, value });
    await send("POST", "/documents/faulty/edits", { revision: 1, author: "Ann", operations: [set(port, "to", "Park"), set(port, "when", "True")] });
    await page.getByRole("button", { name: "Draft, 1 error" }).waitFor();
    await send("POST", "/documents/faulty/edits", { revision: 2, author: "Ann", operations: [set(action, "do", "x = 1")] });
    await page.getByRole("region", { name: "Errors" }).waitFor({ state: "detached" });
    await expect.poll(() => page.locator("[data-error], .error-mark, .edit-errors").count()).toBe(0);
    // The list that the top bar offers knows it, too.
    const listed = page.getByRole("combobox", { name: "Document" }).locator("option", { hasText: /^faulty/ });
    await expect.poll(() => listed.innerText()).not.toContain("draft");
    await page.keyboard.press("F5");
    await page.getByRole("status", { name: "Run status" }).getByText("Ready").waitFor();
    await node("Faulty/Park").waitFor();
  });

  it("of a wrong shape cannot be edited, and its errors are listed all the same", async () => {
    const { page, send, screenshot, url } = fixture;
    await send("PUT", "/documents/shape?draft=true", { rcm: 1, root: { state: "R", first: 3, children: [{ x: 1 }] } });
    await page.goto(`${url}/pro/?edit=shape`);
    const errors = page.getByRole("region", { name: "Errors" });
    await errors.getByRole("listitem").nth(2).waitFor();
    // There is nothing to go to; what to do is explained.
    expect(await errors.locator("button.error-text").count()).toBe(0);
    await errors.getByRole("button", { name: "type ?" }).first().click();
    await page.getByRole("dialog", { name: "Help" }).locator("#error-type.is-marked").waitFor();
    await page.keyboard.press("Escape");
    await screenshot("draft-shape");
  });
});

describe("without the server", () => {
  it("nothing can be opened or stored, and the panel says so", async () => {
    const { page, screenshot } = fixture;
    await page.goto(`${fixture.url}/pro/`);
    await openPanel();
    await row("pick").waitFor();
    await fixture.kill();
    await panel().getByText("The server is not there").waitFor();
    for (const name of ["New", "Upload"]) expect(await panel().getByRole("button", { name, exact: true }).isDisabled()).toBe(true);
    for (const name of ["pick", "Duplicate", "Delete", "Download", "New run"]) expect(await row("pick").getByRole("button", { name, exact: true }).isDisabled()).toBe(true);
    await screenshot("documents-offline");
    await fixture.restart();
    await expect.poll(() => row("pick").getByRole("button", { name: "Delete" }).isDisabled()).toBe(false);
  });

  it("a document stays open while edits of it wait, and they are made when the server is there again", async () => {
    const { page } = fixture;
    const { open, select, node, children } = editPage(fixture);
    await open("kept");
    await select("Root/A");
    await fixture.kill();
    await page.getByText(/Server lost/).first().waitFor();
    await page.keyboard.press("Alt+s");
    await node("Root/State").waitFor();
    await page.keyboard.press("Escape");
    await page.keyboard.press("Control+Shift+P");
    await page.keyboard.type("Close the document");
    await page.keyboard.press("Enter");
    await page.getByText("kept stays open: the server is lost, and has not taken 1 edit of this page.").waitFor();
    await node("Root/State").waitFor();
    await fixture.restart();
    await expect.poll(() => children("kept")).toContain("State");
  });
});
