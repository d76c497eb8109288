// The forms of the editor on the real server, by keyboard and mouse: every kind of element, numbers as written, drafts, and the state editor.
import type { Locator, Page } from "playwright-core";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { write } from "./editPage";
import { demo, openFixture, settled, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

interface Json {
  readonly [key: string]: unknown;
  readonly state?: string;
  readonly children?: readonly Json[];
}

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
  fixture.page.setDefaultTimeout(kPatience);
});
afterAll(() => fixture.close());

const text = async (name: string): Promise<string> => (await fetch(`${fixture.url}/api/v1/documents/${name}`)).text();
const rootOf = async (name: string): Promise<Json> => ((await fixture.send("GET", `/documents/${name}`)) as { document: { root: Json } }).document.root;

/** The first state of this name in a document, without ids. */
async function stateIn(name: string, state: string): Promise<Json | undefined> {
  const find = (json: Json): Json | undefined => (json.state === state ? json : json.children?.map(find).find((found) => found !== undefined));
  return without(find(await rootOf(name)));
}
const without = (json: Json | undefined): Json | undefined => json && (JSON.parse(JSON.stringify(json, (key, value: unknown) => (key === "meta" ? undefined : value))) as Json);
const within = (state: () => Promise<unknown>) => expect.poll(state, kSoon);

const form = (page: Page): Locator => page.getByRole("complementary", { name: "Properties" });
const list = (page: Page, name: string | RegExp): Locator => page.getByRole("region", { name });
const rows = (page: Page, name: string | RegExp): Locator => list(page, name).getByRole("listitem");
const focused = (page: Page): Promise<string> => page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? document.activeElement?.tagName ?? "");

async function open(name: string, root: Json, page = fixture.page): Promise<void> {
  await fixture.send("PUT", `/documents/${name}`, { rcm: 1, root });
  await edit(name, page);
}
async function edit(name: string, page = fixture.page): Promise<void> {
  await page.goto(`${fixture.url}/pro/?edit=${name}`);
  await settled(page);
}
const select = (page: Page, name: string) => page.getByRole("treeitem", { name, exact: false }).locator(".tree-name", { hasText: new RegExp(`^${name}$`) }).last().click();

const task = (): Json => ({
  state: "Root", first: "A",
  children: [
    { state: "A", parameters: [{ name: "way", value: 0.25 }], entry: "pass", ports: [{ name: "done", when: "True", to: "B" }, { name: "error", when: "False" }] },
    { state: "B", ports: [{ name: "done", when: "True" }] },
  ],
});

describe("the form of a state", () => {
  it("renames it, with all that names it", async () => {
    const { page } = fixture;
    await open("names", task());
    await select(page, "A");
    const name = form(page).getByRole("textbox", { name: "Name", exact: true }).first();
    await name.fill("Approach");
    await name.press("Enter");
    await within(async () => (await rootOf("names"))["first"]).toBe("Approach");
    await form(page).getByRole("button", { name: "Root" }).waitFor();
    await expect.poll(() => name.inputValue()).toBe("Approach");
  });

  it("keeps numbers as they are written", async () => {
    const { page } = fixture;
    await select(page, "Approach");
    const value = rows(page, "Parameters").getByRole("textbox", { name: "Constant" });
    await value.fill("[0.5, 1.0]");
    await value.press("Enter");
    await within(() => text("names")).toMatch(/"value":\s*\[\s*0\.5,\s*1\.0\s*\]/);
    await edit("names");
    await select(page, "Approach");
    await within(() => value.inputValue()).toBe("[0.5, 1.0]");
    await value.fill("[0.6, 1.0]");
    await value.blur();
    await within(() => text("names")).toMatch(/"value":\s*\[\s*0\.6,\s*1\.0\s*\]/);
    await value.fill("[0.6, ");
    await value.press("Enter");
    await form(page).getByText("no constant of JSON").waitFor();
    await value.press("Escape");
    expect(await value.inputValue()).toBe("[0.6, 1.0]");
    const kind = rows(page, "Parameters").getByRole("button", { name: "Constant: make it an expression" });
    await kind.click();
    await within(async () => (await stateIn("names", "Approach"))?.["parameters"]).toEqual([{ name: "way", from: "[0.6, 1.0]" }]);
    await rows(page, "Parameters").getByRole("button", { name: "Expression: make it a constant" }).click();
    await within(() => text("names")).toMatch(/"value":\s*\[\s*0\.6,\s*1\.0\s*\]/);
  });

  it("takes Enter for a constant whose text as it is written is still on its way", async () => {
    const { page } = fixture;
    await open("late", task());
    await select(page, "A");
    const value = rows(page, "Parameters").getByRole("textbox", { name: "Constant" });
    await value.fill("[0.6, 1.0]");
    await value.press("Enter");
    await within(() => text("late")).toMatch(/"value":\s*\[\s*0\.6,\s*1\.0\s*\]/);
    await within(() => value.inputValue()).toBe("[0.6, 1.0]");
    await value.fill("[0.6, ");
    const asked = "**/api/v1/documents/late";
    await page.route(asked, () => undefined);
    const { revision, document } = (await fixture.send("GET", "/documents/late")) as { readonly revision: number; readonly document: { readonly root: Json } };
    const parameter = (document.root.children?.[0]?.["parameters"] as { readonly meta: { readonly id: string } }[])[0]?.meta.id;
    await fixture.send("POST", "/documents/late/edits", { revision, author: "Ann", operations: [{ op: "set", id: parameter, field: "doc", value: "how far" }] });
    await expect.poll(() => value.getAttribute("readonly"), kSoon).not.toBeNull();
    await value.press("Enter");
    await form(page).getByText("no constant of JSON").waitFor();
    await page.unroute(asked);
    await value.press("Escape");
    await edit("names");
    await select(page, "Approach");
  });

  it("has lists that work by keyboard, and Delete there spares the state", async () => {
    const { page } = fixture;
    await list(page, "Results").getByRole("button", { name: "Add result" }).focus();
    await page.keyboard.press("Enter");
    await page.keyboard.type("first");
    await page.keyboard.press("Enter");
    await page.keyboard.press("Enter");
    await within(async () => ((await stateIn("names", "Approach"))?.["results"] as Json[])[0]).toEqual({ name: "first" });
    await page.keyboard.type("second");
    await page.keyboard.press("Enter");
    await within(async () => (await stateIn("names", "Approach"))?.["results"]).toEqual([{ name: "first" }, { name: "second" }]);
    await page.keyboard.press("Alt+ArrowUp");
    await within(async () => (await stateIn("names", "Approach"))?.["results"]).toEqual([{ name: "second" }, { name: "first" }]);
    await expect.poll(() => page.evaluate(() => (document.activeElement as HTMLInputElement).value)).toBe("second");
    await page.keyboard.press("Shift+Tab");
    await expect.poll(() => focused(page)).toBe("result second, 1 of 2");
    await page.keyboard.press("Delete");
    await within(async () => (await stateIn("names", "Approach"))?.["results"]).toEqual([{ name: "first" }]);
    await expect.poll(() => focused(page)).toBe("result first, 1 of 1");
    await page.keyboard.press("Delete");
    await within(async () => (await stateIn("names", "Approach"))?.["results"]).toBeUndefined();
    await expect.poll(() => focused(page)).toBe("Add result");
    await page.keyboard.press("Delete");
    expect((await rootOf("names")).children).toHaveLength(2);
  });

  it("shows the order of ports, which dragging changes", async () => {
    const { page } = fixture;
    const ports = rows(page, /^Ports/);
    expect(await ports.first().locator(".row-handle").textContent()).toBe("⠿");
    const condition = ports.nth(1).getByRole("textbox", { name: "Condition" });
    await write(condition, "available(res.x)");
    await condition.press("Enter");
    await within(() => ports.nth(1).locator(".row-handle").textContent()).toBe("2");
    await form(page).getByText("Ports, in order of evaluation").waitFor();
    await form(page).locator(".field-error").first().waitFor();
    // Rows move while errors appear below them.
    const top = async () => (await ports.nth(1).locator(".row-handle").boundingBox())?.y;
    let before = await top();
    await expect.poll(async () => [before, (before = await top())].every((y, _, all) => y === all[0]), { interval: 300 }).toBe(true);
    // What hovers over the text that was clicked goes.
    await page.mouse.move(700, 800);
    await page.locator(".cm-tooltip").waitFor({ state: "detached" });
    const [from, to] = [await ports.nth(1).locator(".row-handle").boundingBox(), await ports.nth(0).boundingBox()];
    if (from === null || to === null) throw new Error("no rows");
    await page.mouse.move(from.x + 6, from.y + 8);
    await page.mouse.down();
    await page.mouse.move(from.x + 6, to.y + 10, { steps: 4 });
    await page.mouse.move(from.x + 6, to.y + 2, { steps: 2 });
    await page.mouse.up();
    await within(async () => ((await stateIn("names", "Approach"))?.["ports"] as Json[]).map((port) => port["name"])).toEqual(["error", "done"]);
  });

  it("chooses a target with Enter, not with each arrow", async () => {
    const { page } = fixture;
    const target = rows(page, /^Ports/).nth(0).getByRole("combobox", { name: "Leads to" });
    await target.focus();
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowDown");
    await form(page).getByText("Enter takes it").waitFor();
    expect(((await stateIn("names", "Approach"))?.["ports"] as Json[])[0]?.["to"]).toBeUndefined();
    await page.keyboard.press("Escape");
    expect(await target.inputValue()).toBe("");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Enter");
    await within(async () => ((await stateIn("names", "Approach"))?.["ports"] as Json[])[0]?.["to"]).toBe("B");
  });

  it("has a time-out in place of a condition", async () => {
    const { page } = fixture;
    const port = rows(page, /^Ports/).nth(0);
    await port.getByRole("button", { name: "Condition: make it a time-out" }).click();
    const time = port.getByRole("textbox", { name: "Time-out in seconds" });
    await write(time, "2.5");
    await time.press("Enter");
    await within(async () => ((await stateIn("names", "Approach"))?.["ports"] as Json[])[0]).toEqual({ name: "error", after: "2.5", to: "B" });
  });

  it("says what begins, what is kept, and what an oracle decides", async () => {
    const { page } = fixture;
    await form(page).getByRole("combobox", { name: "Its values" }).selectOption("deep");
    await within(async () => (await stateIn("names", "Approach"))?.["keep"]).toEqual({ deep: true });
    await form(page).getByRole("checkbox", { name: "any port" }).uncheck();
    await form(page).getByRole("checkbox", { name: "done" }).check();
    await within(async () => (await stateIn("names", "Approach"))?.["keep"]).toEqual({ deep: true, ports: ["done"] });
    await form(page).getByRole("button", { name: "Root" }).click();
    await form(page).getByRole("combobox", { name: "Begins with" }).selectOption("B");
    await within(async () => (await rootOf("names"))["first"]).toBe("B");
    await form(page).getByRole("combobox", { name: "Chosen" }).selectOption("history");
    await form(page).getByRole("checkbox", { name: "Also inside" }).check();
    await within(async () => (await rootOf("names"))["oracle"]).toEqual({ kind: "history", deep: true });
    await form(page).getByRole("combobox", { name: "Chosen" }).selectOption("expr");
    const expression = form(page).getByRole("textbox", { name: "Name of the child" });
    await write(expression, "'B'");
    await expression.press("Enter");
    await within(async () => (await rootOf("names"))["oracle"]).toEqual({ kind: "expr", expr: "'B'" });
  });
});

describe("the forms of a barrier, a port and the document", () => {
  it("edit them", async () => {
    const { page } = fixture;
    const root = { state: "Root", first: "Fork", children: [{ barrier: "Fork", to: ["A"] }, { state: "A", ports: [{ name: "done", when: "True" }] }, { state: "B" }] };
    await open("kinds", root);
    await select(page, "Fork");
    await form(page).getByRole("combobox", { name: "Add" }).selectOption("B");
    await within(async () => (await rootOf("kinds")).children?.[0]?.["to"]).toEqual(["A", "B"]);
    await rows(page, "Leads to").nth(1).locator(".row-handle").focus();
    await page.keyboard.press("Alt+ArrowUp");
    await within(async () => (await rootOf("kinds")).children?.[0]?.["to"]).toEqual(["B", "A"]);
    await page.keyboard.press("Delete");
    await within(async () => (await rootOf("kinds")).children?.[0]?.["to"]).toEqual(["A"]);

    await settled(page);
    await page.locator('[aria-label^="Port Root/A.done"]').first().click();
    await form(page).getByText("Port in").waitFor();
    await form(page).getByRole("combobox", { name: "Leads to" }).selectOption("B");
    await within(async () => ((await stateIn("kinds", "A"))?.["ports"] as Json[])[0]?.["to"]).toBe("B");

    // From the form to the drawing, then away from what is selected.
    await page.keyboard.press("Escape");
    await page.keyboard.press("Escape");
    await form(page).getByRole("combobox", { name: "Add" }).selectOption("gripper");
    await within(() => text("kinds")).toMatch(/"services":\s*\{\s*"gripper":\s*"gripper"/);
    const key = rows(page, "Services").getByRole("textbox", { name: "Key" });
    await key.fill("hand");
    await key.press("Enter");
    await within(() => text("kinds")).toMatch(/"services":\s*\{\s*"hand":\s*"gripper"/);
  });
});

describe("a draft", () => {
  it("is kept, never overwrites what somebody else wrote, and is sent when its author says so", async () => {
    const { page, openPage, screenshot } = fixture;
    await open("drafts", task());
    await select(page, "A");
    const entry = form(page).getByRole("textbox", { name: "Entry" });
    await write(entry, "print('mine')");
    await form(page).page().getByText("1 unsent text").waitFor();
    await page.reload();
    await settled(page);
    await expect.poll(() => page.getByText("1 unsent text").count()).toBe(1);
    expect((await stateIn("drafts", "A"))?.["entry"]).toBe("pass");

    const other = await openPage();
    other.setDefaultTimeout(kPatience);
    await edit("drafts", other);
    await select(other, "A");
    const theirs = form(other).getByRole("textbox", { name: "Entry" });
    await write(theirs, "print('theirs')");
    await theirs.press("Control+Enter");
    await within(async () => (await stateIn("drafts", "A"))?.["entry"]).toBe("print('theirs')");

    await page.getByText("1 unsent text").click();
    await page.getByRole("button", { name: "Root › A › entry", exact: true }).click();
    await form(page).getByText("changed this to").waitFor();
    await within(() => entry.innerText()).toBe("print('mine')");
    await entry.press("Control+Enter");
    await entry.blur();
    await page.waitForTimeout(300);
    expect((await stateIn("drafts", "A"))?.["entry"]).toBe("print('theirs')");
    await screenshot("forms-conflict");
    await form(page).getByRole("button", { name: "Keep mine" }).click();
    await within(async () => (await stateIn("drafts", "A"))?.["entry"]).toBe("print('mine')");
    await within(() => page.getByText("unsent text").count()).toBe(0);
    await within(() => theirs.innerText()).toBe("print('mine')");
    await other.close();
  });

  it("that is refused stays, with the reason", async () => {
    const { page } = fixture;
    const entry = form(page).getByRole("textbox", { name: "Entry" });
    await write(entry, "res.done = (par.way");
    await entry.press("Control+Enter");
    await form(page).locator(".field-error").first().waitFor();
    const name = rows(page, "Parameters").getByRole("textbox", { name: "Name" });
    await name.fill("path");
    await name.press("Enter");
    await rows(page, "Parameters").getByText("cannot be parsed").waitFor();
    await expect.poll(() => name.inputValue()).toBe("path");
    await page.getByText("1 unsent text").waitFor();
    await name.press("Escape");
    await expect.poll(() => name.inputValue()).toBe("way");
  });
});

describe("the state editor", () => {
  it("builds the state that stores a pose (Fig. A.2, 5.1) as the demonstrator has it", async () => {
    const { page, send, screenshot } = fixture;
    const { library } = JSON.parse(readFileSync(join(demo, "demonstrator.rcm.json"), "utf8")) as { library: Json[] };
    const wanted = library.flatMap(({ children }) => children ?? []).find(({ state }) => state === "SaveObjectPose");
    await send("PUT", "/documents/store", { rcm: 1, root: { state: "ObjectRecognition", first: "SaveObjectPose", children: [{ state: "SaveObjectPose" }] } });
    await edit("store");
    await select(page, "SaveObjectPose");
    await form(page).getByRole("textbox", { name: "Description" }).fill("Where Pick will look for it.");
    await form(page).getByRole("button", { name: "Wide form" }).click();
    const editor = page.getByRole("region", { name: "State editor" });
    const { keyboard } = page;
    // By keyboard from here on.
    await editor.getByRole("button", { name: "Add parameter" }).focus();
    for (const [name, from, type] of [["key", "par.key", ""], ["pose", "chi.GetGraspPose.res.o_t_x", "pose"]] as const) {
      if (name === "key") await keyboard.press("Enter");
      await keyboard.type(name);
      await keyboard.press("Enter");
      await keyboard.press("Tab");
      await keyboard.press("Enter");
      await keyboard.press("Tab");
      await keyboard.type(from);
      await keyboard.press("Enter");
      if (type !== "") {
        await keyboard.press("Tab");
        await keyboard.press("Enter");
        await keyboard.press("Tab");
        await keyboard.type(type);
        await keyboard.press("Enter");
      }
      if (name === "key") await keyboard.press("Enter");
    }
    await editor.getByRole("textbox", { name: "Entry" }).focus();
    await keyboard.type("svc.db.add(par.key, par.pose)");
    await keyboard.press("Control+Enter");
    await editor.getByRole("button", { name: "Add port" }).focus();
    for (const [name, when] of [["success", "svc.db.add.result == par.key"], ["error", "svc.db.add.error"]] as const) {
      // The first port is called `success` as it is made.
      if (name === "success") await keyboard.press("Enter");
      else await keyboard.type(name);
      if (name !== "success") await keyboard.press("Enter");
      const condition = editor.getByRole("textbox", { name: "Condition" }).last();
      await condition.focus();
      await keyboard.press("Control+A");
      await keyboard.type(when);
      await keyboard.press("Enter");
      if (name === "success") await keyboard.press("Enter");
    }
    await within(() => stateIn("store", "SaveObjectPose")).toEqual(without(wanted));
    await screenshot("forms-editor");
    await page.setViewportSize({ width: 1366, height: 768 });
    await page.waitForTimeout(300);
    await screenshot("forms-editor-1366");
    await keyboard.press("Escape");
    await within(() => editor.count()).toBe(0);
    await page.waitForTimeout(300);
    await screenshot("forms-state-1366");
    expect(await form(page).evaluate((side) => side.scrollWidth <= side.clientWidth)).toBe(true);
    await page.setViewportSize({ width: 1600, height: 1000 });
  });

  it("fits what is largest in the demonstrator", async () => {
    const { page, send, screenshot } = fixture;
    await send("PUT", "/documents/big", { ...(JSON.parse(readFileSync(join(demo, "demonstrator.rcm.json"), "utf8")) as Json) });
    await edit("big");
    await screenshot("forms-document");
    await page.getByRole("treeitem").first().locator(".tree-name").first().click();
    await screenshot("forms-root");
    expect(await form(page).evaluate((side) => side.scrollWidth <= side.clientWidth)).toBe(true);
  });
});
