// The run of the document that is edited, on the real server: it is seen on the edited drawing, takes edits while it runs, waits with them, and is
// never taken for another one. What fires in these tasks is forced, so nothing happens by itself.
import { findings } from "./axe";
import { editPage, write } from "./editPage";
import { openFixture, settled, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
  fixture.page.setDefaultTimeout(kPatience);
  await fixture.page.setViewportSize({ width: 1366, height: 768 });
  // A port may be gone while its condition is asked for: it is not found.
  fixture.allowError(/ 404 .*\/why\?/);
});
afterAll(() => fixture.close());

const soon = (value: () => unknown) => expect.poll(value, kSoon);

interface CoreJson {
  readonly id: string;
  readonly document: string;
  readonly status: string;
  readonly revision: number;
  readonly step: number;
  readonly waiting_edit?: object;
}
const core = async (id: string) => (await fixture.send("GET", `/cores/${id}`)) as CoreJson;
const stateOf = async (id: string) =>
  ((await fixture.send("GET", `/cores/${id}/state`)) as { readonly state: { readonly active: readonly string[]; readonly parameters: Readonly<Record<string, Readonly<Record<string, unknown>>>> } }).state;
const revision = async (name: string) => ((await fixture.send("GET", `/documents/${name}`)) as { readonly revision: number }).revision;
const force = (id: string, path: string, name = "next") => fixture.send("POST", `/cores/${id}/force`, { path, scope: "port", name });

/** A and B take turns, as far as their ports are forced; C is never entered. */
const task = {
  rcm: 1,
  root: {
    state: "Root", first: "A", variables: [{ name: "n", initial: 1 }], ports: [{ name: "done", when: "False" }],
    children: [
      { state: "A", ports: [{ name: "next", when: "False", to: "B" }] },
      { state: "B", parameters: [{ name: "speed", value: 0.3 }], ports: [{ name: "next", when: "False", to: "A" }, { name: "lost", when: "False", to: "C" }] },
      { state: "C" },
    ],
  },
};

/** Stores the document, makes a run of it, and opens both. */
async function open(name: string, { start = true, live = true } = {}): Promise<string> {
  await fixture.send("PUT", `/documents/${name}`, task);
  const { id } = (await fixture.send("POST", "/cores", { document: name, arguments: {} })) as CoreJson;
  if (live) await fixture.send("PUT", `/cores/${id}/live`, { live: true });
  if (start) await fixture.send("POST", `/cores/${id}/start`);
  await fixture.page.goto(`${fixture.url}/pro/?run=${id}&edit=${name}`);
  await settled(fixture.page);
  return id;
}

const bar = () => fixture.page.getByRole("region", { name: "Run of this document" });
const form = () => fixture.page.getByRole("complementary", { name: "Properties" });
const rows = (list: string | RegExp) => form().getByRole("region", { name: list });
const waiting = () => fixture.page.getByRole("status", { name: "Waiting edit" });
const carried = () => fixture.page.getByRole("status", { name: "Edit in the run" });
const toolbar = () => fixture.page.getByRole("toolbar", { name: "Run" });
const isActive = (path: string) => editPage(fixture).node(path).getAttribute("data-active");
const marks = () => fixture.page.locator(".difference-mark");

/** Begins or ends to follow edits: the server says when. */
const follow = () => fixture.page.getByRole("checkbox", { name: "Follow edits" }).click();

/** Writes a condition of the selected state, the first one or another one. */
async function writeCondition(text: string, at = 0): Promise<void> {
  const field = rows(/^Ports/).getByRole("textbox", { name: "Condition" }).nth(at);
  await write(field, text);
  await field.press("Enter");
}

describe("the run of the document that is edited", () => {
  it("is seen on the edited drawing, by what its elements are and not by their names", async () => {
    const { select, node } = editPage(fixture);
    const id = await open("seen", { live: false });
    await soon(() => isActive("Root/A")).toBe("true");
    await soon(() => bar().innerText()).toContain(`Run ${id} executes revision 1, which you edit`);
    await select("Root/A");
    await fixture.page.keyboard.press("F2");
    await fixture.page.getByRole("textbox", { name: "Name of A" }).fill("Approach");
    await fixture.page.keyboard.press("Enter");
    await node("Root/Approach").waitFor();
    await soon(() => isActive("Root/Approach")).toBe("true");
    await soon(async () => (await bar().innerText()).replace(/\s+/g, " ")).toMatch(new RegExp(`^Run ${id} executes revision 1; you edit revision 2 \\d changes`));
    expect((await core(id)).revision).toBe(1);
    await force(id, "Root/A");
    await soon(() => isActive("Root/B")).toBe("true");
    await expect.poll(() => isActive("Root/Approach")).toBe("false");
    await soon(() => fixture.page.getByRole("treeitem", { name: "Root/B" }).getAttribute("data-active")).toBe("true");
  });

  it("is hidden when it is not wanted, with its values and marks", async () => {
    const { select } = editPage(fixture);
    await select("Root/B");
    await soon(() => rows("Parameters").locator(".row-now").innerText()).toBe("now: 0.3");
    await soon(() => marks().count()).toBeGreaterThan(0);
    await fixture.page.getByRole("checkbox", { name: "Show the run" }).uncheck();
    await soon(() => isActive("Root/B")).toBe("false");
    await expect.poll(async () => [await marks().count(), await form().locator(".row-now").count()]).toEqual([0, 0]);
    await fixture.page.getByRole("checkbox", { name: "Show the run" }).check();
    await soon(() => isActive("Root/B")).toBe("true");
  });

  it("differs by a list that leads to each element, with signs in the drawing", async () => {
    const { select, children, node } = editPage(fixture);
    await select("Root/C");
    await fixture.page.keyboard.press("Delete");
    await soon(() => children("seen")).toEqual(["Approach", "B"]);
    await select("Root/B");
    await fixture.page.keyboard.press("Alt+s");
    await node("Root/State").waitFor();
    await settled(fixture.page);
    await bar().getByRole("button", { name: /^\d+ changes/ }).click();
    const list = fixture.page.getByRole("list", { name: "Changes that the run does not execute" });
    const texts = async () => (await list.getByRole("listitem").allInnerTexts()).map((text) => text.replace(/\s+/g, " "));
    await soon(texts).toEqual(expect.arrayContaining([expect.stringContaining("added state Root/State"), expect.stringContaining("removed state Root/C"), expect.stringMatching(/changed state Root\/Approach state: 'A' → 'Approach'/)]));
    await list.getByRole("button", { name: /changed state Root\/Approach/ }).click();
    await soon(() => node("Root/Approach").getAttribute("class")).toContain("is-selected");
    await list.getByRole("button", { name: /removed state Root\/C/ }).click();
    await soon(() => node("Root").getAttribute("class")).toContain("is-selected");
    await soon(async () => [...(await marks().allInnerTexts())].sort()).toEqual(expect.arrayContaining(["+", "≠"]));
    expect(await findings(fixture.page)).toEqual([]);
    await fixture.screenshot("live-difference");
    await bar().getByRole("button", { name: /^\d+ changes/ }).click();
  });

  it("gets the edits when it is told to follow them, and says since when", async () => {
    const [run] = ((await fixture.send("GET", "/cores")) as { readonly cores: readonly CoreJson[] }).cores.filter(({ document }) => document === "seen");
    const id = run?.id ?? "";
    const { select } = editPage(fixture);
    await follow();
    const last = await revision("seen");
    await soon(() => carried().innerText()).toMatch(new RegExp(`^Run ${id} executes revision ${last} since step \\d+$`));
    await soon(() => bar().innerText()).toContain(`executes revision ${last}, which you edit`);
    await expect.poll(() => marks().count()).toBe(0);
    await select("Root/B");
    await soon(() => rows(/^Ports/).locator(".row-now").first().innerText()).toBe("now: false");
    await fixture.screenshot("live-carried");
    await rows(/^Ports/).getByRole("button", { name: "Why, in the run: this port" }).first().click();
    await soon(() => fixture.page.getByRole("region", { name: "Why", exact: true }).innerText()).toMatch(/Does not fire|Never fires/);
    await fixture.page.goBack();
    await select("Root/B");
    await writeCondition("True");
    await soon(async () => (await stateOf(id)).active).toEqual(["Root", "Root/Approach"]);
    await soon(() => isActive("Root/Approach")).toBe("true");
  });
});

describe("a parameter that is edited while its state is active", () => {
  it("is used from the next activation on, and is taken back by undo", async () => {
    const { select } = editPage(fixture);
    const id = await open("speed");
    await force(id, "Root/A");
    await select("Root/B");
    const now = () => rows("Parameters").locator(".row-now").innerText();
    await soon(now).toBe("now: 0.3");
    const field = rows("Parameters").getByRole("textbox", { name: "Constant" });
    await field.fill("0.9");
    await field.press("Enter");
    await soon(now).toBe("used from the next activation on; now: 0.3");
    await fixture.screenshot("live-parameter");
    expect((await stateOf(id)).parameters["Root/B"]).toEqual({ speed: 0.3 });
    await force(id, "Root/B");
    await force(id, "Root/A");
    await soon(now).toBe("now: 0.9");
    expect((await stateOf(id)).parameters["Root/B"]).toEqual({ speed: 0.9 });
    await fixture.page.getByRole("button", { name: "Undo" }).click();
    await soon(now).toBe("used from the next activation on; now: 0.9");
    await soon(async () => (await core(id)).revision).toBe(3);
    await soon(() => bar().innerText()).toContain("executes revision 3, which you edit");
    await force(id, "Root/B");
    await force(id, "Root/A");
    await soon(now).toBe("now: 0.3");
  });
});

describe("an edit that the run cannot take", () => {
  it("now, waits for the state that it names, and is carried when that is left", async () => {
    const { select, children, canvas } = editPage(fixture);
    const id = await open("waits");
    await force(id, "Root/A");
    await select("Root/B");
    await fixture.page.keyboard.press("Delete");
    await soon(() => children("waits")).toEqual(["A", "C"]);
    const last = await revision("waits");
    await soon(() => waiting().innerText()).toContain(`Revision ${last} of waits waits until B is left`);
    await expect.poll(() => canvas.locator('[data-active="true"]').count(), { message: "the root alone is active and still in the document" }).toBe(1);
    await fixture.screenshot("live-waits");
    await waiting().getByRole("button", { name: /Root\/B is active/ }).click();
    await soon(() => fixture.page.getByRole("tab", { name: "Task" }).getAttribute("aria-selected")).toBe("true");
    await soon(() => fixture.page.locator('.canvas .is-selected[data-path="Root/B"]').getAttribute("data-active")).toBe("true");
    await toolbar().getByRole("button", { name: "Edit" }).or(fixture.page.getByRole("tab", { name: "Edit" })).first().click();
    await settled(fixture.page);
    await force(id, "Root/B");
    await soon(async () => (await core(id)).revision).toBe(last);
    await soon(() => waiting().count()).toBe(0);
    await soon(() => isActive("Root/A")).toBe("true");
    await soon(() => carried().innerText()).toContain(`executes revision ${last} since step`);
  });

  it("ever, is told with its errors, which lead to what they are about, until it is taken back", async () => {
    const { select, port } = editPage(fixture);
    const id = await open("wrong");
    await select("Root/A");
    await writeCondition("par.nothing > 1");
    await soon(() => waiting().innerText()).toContain("Revision 2 of wrong has 1 error and cannot be executed");
    await select("Root/C");
    await waiting().getByRole("button", { name: /nothing/ }).click();
    await soon(() => port("Root/A.next").getAttribute("class")).toContain("is-selected");
    await fixture.screenshot("live-refused");
    await fixture.page.getByRole("button", { name: "Undo" }).click();
    await soon(() => waiting().count()).toBe(0);
    await soon(async () => (await core(id)).revision).toBe(3);
    expect((await stateOf(id)).active).toEqual(["Root", "Root/A"]);
  });
});

describe("a run of another document", () => {
  it("is never shown in the one that is edited, though all is called the same and has the same ids", async () => {
    const { node } = editPage(fixture);
    const id = await open("original");
    await soon(() => isActive("Root/A")).toBe("true");
    await fixture.send("POST", "/documents/original/branch", { as: "twin", author: "me" });
    await fixture.page.goto(`${fixture.url}/pro/?run=${id}&edit=twin`);
    await settled(fixture.page);
    await soon(() => toolbar().innerText()).toContain(`Run ${id} of original, revision 1: not what you edit`);
    await soon(async () => [await isActive("Root"), await isActive("Root/A"), await bar().count()]).toEqual(["false", "false", 0]);
    await node("Root/A").click({ position: { x: 20, y: 8 } });
    expect(await form().locator(".row-now").count()).toBe(0);
    for (const name of ["Start", "Resume", "Micro step", "Macro step"]) for (const each of await toolbar().getByRole("button", { name }).all()) expect(await each.isDisabled(), name).toBe(true);
    await soon(() => toolbar().getByRole("button", { name: "Stop" }).isEnabled()).toBe(true);
    await fixture.screenshot("live-other");
  });

  it("is not turned from while it is under way, and one of this document is offered", async () => {
    const twin = (await fixture.send("POST", "/cores", { document: "twin", arguments: {} })) as CoreJson;
    await bar().getByRole("button", { name: `Show run ${twin.id} of this document` }).waitFor();
    await soon(() => bar().innerText()).toMatch(/^You watch run \d+ of original, which is not shown here\./);
    await bar().getByRole("button", { name: /^Show run/ }).click();
    await soon(() => bar().innerText()).toContain(`Run ${twin.id} will execute revision 1, which you edit`);
    await toolbar().getByRole("button", { name: "Edit" }).waitFor({ state: "detached" });
  });

  it("is moved by nothing but its buttons", async () => {
    const id = new URL(fixture.page.url()).searchParams.get("run") ?? "";
    await editPage(fixture).select("Root/A");
    for (const key of ["F4", "Shift+F4"]) await fixture.page.keyboard.press(key);
    expect((await core(id)).status).toBe("ready");
    await toolbar().getByRole("button", { name: "Start" }).click();
    await soon(() => isActive("Root/A")).toBe("true");
    await toolbar().getByRole("button", { name: "Pause" }).click();
    await soon(() => toolbar().innerText()).toContain("Paused");
    await toolbar().getByRole("button", { name: "Stop" }).click();
    await soon(async () => (await core(id)).status).toBe("aborted");
    await soon(() => bar().innerText()).toContain("is over; it executed revision 1");
  });
});

describe("the page of the run", () => {
  it("says which revision of which document runs, and leads to its edit", async () => {
    const { page, url } = fixture;
    const id = await open("page");
    await page.goto(`${url}/pro/?run=${id}`);
    await settled(page);
    await soon(() => toolbar().innerText()).toContain(`Run ${id} of page, revision 1`);
    await fixture.screenshot("live-run-page");
    await toolbar().getByRole("button", { name: "Edit" }).click();
    await soon(() => bar().innerText()).toContain(`Run ${id} executes revision 1, which you edit`);
    await soon(() => new URL(page.url()).searchParams.get("edit")).toBe("page");
    await soon(() => isActive("Root/A")).toBe("true");
    const choose = async (command: string) => {
      await page.keyboard.press("Control+Shift+p");
      await page.getByRole("dialog", { name: "Commands" }).getByRole("combobox").fill(command);
      await page.keyboard.press("Enter");
    };
    await choose("Show the run on the drawing");
    await soon(() => isActive("Root/A")).toBe("false");
    await choose("Show the run on the drawing");
    await soon(() => isActive("Root/A")).toBe("true");
  });

  it("looks well in both themes and on a wide screen", async () => {
    const { page, screenshot } = fixture;
    const { select, node } = editPage(fixture);
    await follow();
    await soon(() => page.getByRole("checkbox", { name: "Follow edits" }).isChecked()).toBe(false);
    await select("Root/B");
    await page.keyboard.press("Alt+s");
    await node("Root/State").waitFor();
    await select("Root/A");
    await bar().getByRole("button", { name: /change/ }).click();
    for (const size of [{ width: 1366, height: 768 }, { width: 2560, height: 1440 }])
      for (const colorScheme of ["light", "dark"] as const) {
        await page.setViewportSize(size);
        // Colours that fade from one theme into the other would be measured half way.
        await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
        await settled(page);
        expect(await findings(page)).toEqual([]);
        await screenshot(`live-${size.width}-${colorScheme}`);
      }
  });
});
