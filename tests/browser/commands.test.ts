// The commands of the page that edits, by key, palette and menu; and what must not happen by accident.
import { editPage } from "./editPage";
import { openFixture, settled, type Fixture } from "./fixture";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
});
afterAll(() => fixture.close());

const keys = async (...all: readonly string[]) => {
  for (const key of all) await fixture.page.keyboard.press(key);
};

describe("keys in the drawing", () => {
  it("rename in place, and Esc keeps the name", async () => {
    const { open, select, node, children } = editPage(fixture);
    await open("rename");
    await select("Root/A");
    await keys("F2");
    const field = fixture.page.getByRole("textbox", { name: "Name of A" });
    await field.fill("2nd");
    await keys("Enter");
    expect(await fixture.page.getByRole("alert").innerText()).toContain("begins with no digit");
    await field.fill("Approach");
    await fixture.screenshot("edit-rename");
    await keys("Enter");
    await node("Root/Approach").waitFor();
    await keys("F2");
    await fixture.page.getByRole("textbox", { name: "Name of Approach" }).fill("Other");
    await keys("Escape");
    expect(await children("rename")).toEqual(["Approach", "B", "C", "Both"]);
  });

  it("add, order, group, ungroup, undo and redo", async () => {
    const { open, select, node, children } = editPage(fixture);
    await open("structure");
    await select("Root/A");
    await keys("Alt+s");
    await expect.poll(() => children("structure")).toEqual(["A", "State", "B", "C", "Both"]);
    await keys("Alt+ArrowUp");
    await expect.poll(() => children("structure")).toEqual(["State", "A", "B", "C", "Both"]);
    await keys("Control+z");
    await expect.poll(() => children("structure")).toEqual(["A", "State", "B", "C", "Both"]);
    await keys("Control+y");
    await expect.poll(() => children("structure")).toEqual(["State", "A", "B", "C", "Both"]);
    await node("Root/State").waitFor();
    await select("Root/A");
    await node("Root/B").click({ position: { x: 20, y: 8 }, modifiers: ["Control"] });
    await keys("Control+g");
    await fixture.page.getByRole("textbox", { name: "Name of the new state" }).fill("Pick");
    await keys("Enter");
    await node("Root/Pick/A").waitFor();
    await settled(fixture.page);
    await fixture.screenshot("edit-group");
    await select("Root/Pick");
    await keys("Control+Shift+g");
    await expect.poll(() => children("structure")).toEqual(["State", "A", "B", "C", "Both"]);
  });

  it("duplicate several as one step, which lead to each other", async () => {
    const { open, select, node, children, state } = editPage(fixture);
    await open("several");
    await select("Root/A");
    await node("Root/B").click({ position: { x: 20, y: 8 }, modifiers: ["Control"] });
    await keys("Control+d");
    await expect.poll(() => children("several")).toEqual(["A", "B", "A2", "B2", "C", "Both"]);
    expect((await state("several", "A2"))?.ports?.[0]?.to).toBe("B2");
    await keys("Control+z");
    await expect.poll(() => children("several")).toEqual(["A", "B", "C", "Both"]);
  });

  it("delete what is selected; a second Delete after a port deletes nothing", async () => {
    const { open, select, port, state, children } = editPage(fixture);
    await open("delete");
    await settled(fixture.page);
    await port("Root/A.done").click();
    await keys("Delete", "Delete");
    await expect.poll(async () => (await state("delete", "A"))?.ports).toBeUndefined();
    expect(await children("delete")).toEqual(["A", "B", "C", "Both"]);
    await select("Root/C");
    await fixture.screenshot("edit-delete");
    await keys("Backspace");
    await expect.poll(() => children("delete")).toEqual(["A", "B", "Both"]);
    expect((await state("delete", "Both"))?.to).toEqual([]);
  });

  it("walk between siblings, in and out", async () => {
    const { open, select, canvas } = editPage(fixture);
    await open("walk");
    await select("Root/A");
    const selected = () => canvas.locator(".is-selected").getAttribute("aria-label");
    await keys("ArrowRight");
    await expect.poll(selected).toContain("Root/B");
    await keys("ArrowRight", "ArrowDown");
    await expect.poll(selected).toContain("Root/C/D");
    await keys("ArrowUp", "ArrowLeft", "Shift+ArrowDown");
    await expect.poll(selected).toContain("Root/B.done");
  });

  it("connect by a list of the siblings", async () => {
    const { open, port, state } = editPage(fixture);
    await open("connect");
    await port("Root/B.done").click();
    await keys("Control+l");
    const menu = fixture.page.getByRole("menu", { name: "Connect to" });
    await menu.waitFor();
    await fixture.screenshot("edit-connect");
    await keys("c", "Enter");
    await expect.poll(async () => (await state("connect", "B"))?.ports?.[0]?.to).toBe("C");
  });
});

describe("the command palette", () => {
  it("finds a command by letters, says why another one cannot be done, and returns the focus", async () => {
    const { open, select, children } = editPage(fixture);
    await open("palette");
    await select("Root/A");
    await keys("Control+Shift+p");
    const palette = fixture.page.getByRole("dialog", { name: "Commands" });
    await palette.getByRole("combobox").fill("ungr");
    expect(await palette.getByRole("option").first().innerText()).toContain("it has no states inside");
    await fixture.screenshot("edit-palette");
    await keys("Enter");
    expect(await palette.count()).toBe(1);
    await palette.getByRole("combobox").fill("barr");
    await keys("Enter");
    await expect.poll(() => children("palette")).toEqual(["A", "Barrier", "B", "C", "Both"]);
    expect(await palette.count()).toBe(0);
    await expect.poll(() => fixture.page.evaluate(() => document.activeElement?.id)).toBe("edit-canvas");
  });

  it("leads to the oracle of a state", async () => {
    const { select } = editPage(fixture);
    await select("Root/C");
    await keys("Control+Shift+p");
    await fixture.page.getByRole("dialog", { name: "Commands" }).getByRole("combobox").fill("oracle");
    await keys("Enter");
    await expect.poll(() => fixture.page.getByRole("combobox", { name: "Chosen" }).evaluate((field) => field === document.activeElement)).toBe(true);
  });
});

describe("the context menu", () => {
  it("opens by right click and by key, on what is there", async () => {
    const { open, node, port, children } = editPage(fixture);
    await open("menu");
    await node("Root/B").click({ button: "right", position: { x: 20, y: 8 } });
    const menu = fixture.page.getByRole("menu", { name: "Actions" });
    await menu.getByRole("menuitem", { name: /^Duplicate/ }).click();
    await expect.poll(() => children("menu")).toEqual(["A", "B", "B2", "C", "Both"]);
    await settled(fixture.page);
    await port("Root/A.done").click();
    await keys("Shift+F10");
    await menu.waitFor();
    expect(await menu.getByRole("menuitem").first().innerText()).toContain("Rename");
    await fixture.screenshot("edit-menu");
    await keys("Escape");
    expect(await menu.count()).toBe(0);
  });
});

describe("F5 on the page that edits", () => {
  const cores = async () => ((await fixture.send("GET", "/cores")) as { readonly cores: readonly { readonly document: string; readonly status: string }[] }).cores;

  it("makes one run and starts nothing, held or pressed twice", async () => {
    const { open, select } = editPage(fixture);
    await open("run");
    await select("Root/A");
    await fixture.page.keyboard.down("F5");
    for (let i = 0; i < 5; ++i) await fixture.page.keyboard.down("F5");
    await fixture.page.keyboard.up("F5");
    await expect.poll(() => fixture.page.getByRole("tab", { name: "Task" }).getAttribute("aria-selected")).toBe("true");
    await keys("F5");
    const made = async () => (await cores()).filter(({ document }) => document === "run").map(({ status }) => status);
    await expect.poll(made).toEqual(["ready"]);
    await new Promise((resolve) => setTimeout(resolve, 500));
    expect(await made()).toEqual(["ready"]);
  });

  it("says why a draft makes none", async () => {
    const { open, select, told } = editPage(fixture);
    await open("draft");
    await select("Root/A");
    await keys("Alt+p");
    await fixture.page.getByText("Draft, ").waitFor();
    await keys("F5");
    await expect.poll(() => told.innerText()).toContain("cannot be started");
    expect((await cores()).some(({ document }) => document === "draft")).toBe(false);
  });
});

describe("keys while one types", () => {
  it("are characters", async () => {
    const { open, select, children } = editPage(fixture);
    await open("typing");
    await select("Root/A");
    await keys("Control+f");
    await fixture.page.keyboard.type("ab");
    await keys("Backspace", "Delete", "Control+a", "Backspace");
    expect(await children("typing")).toEqual(["A", "B", "C", "Both"]);
    await keys("Control+s");
    await expect.poll(() => fixture.page.getByText("All is saved").count()).toBe(1);
  });
});

describe("the help", () => {
  it("has the keys of the editor, too", async () => {
    const { open } = editPage(fixture);
    await open("help");
    await keys("?");
    const help = fixture.page.getByRole("dialog", { name: "Keys and mouse" });
    expect(await help.locator("kbd").allInnerTexts()).toEqual(expect.arrayContaining(["F2", "Ctrl+G", "Ctrl+Shift+P", "Alt+ArrowUp"]));
    await fixture.screenshot("edit-help");
  });
});
