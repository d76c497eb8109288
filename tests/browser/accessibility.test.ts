// axe-core finds nothing on any page, in the light and in the dark theme.
import type { Page } from "playwright-core";
import { findings } from "./axe";
import { openFixture, settled, type Fixture } from "./fixture";
import { letMove } from "./hands";
import { reachNode, showStep } from "./proofText";

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
  // Findings are of the page at rest, not of a colour on its way to another.
  await page.emulateMedia({ reducedMotion: "reduce" });
});
afterAll(() => fixture.close());

const tab = (name: string) => page.getByRole("tab", { name, exact: true }).click();

/** The findings of the page in both themes, each with the theme. */
async function inBothThemes(of = page): Promise<readonly string[]> {
  const found: string[] = [];
  for (const colorScheme of ["light", "dark"] as const) {
    await of.emulateMedia({ colorScheme, reducedMotion: "reduce" });
    found.push(...(await findings(of)).map((finding) => `${colorScheme}: ${finding}`));
  }
  return found;
}

describe("axe-core", () => {
  it("finds a button without a name and pale text", async () => {
    await page.goto(`${fixture.url}/pro/`);
    await page.getByRole("button", { name: "Load" }).waitFor();
    await page.evaluate(() => {
      const button = document.createElement("button");
      const text = document.createElement("p");
      text.textContent = "pale";
      text.style.cssText = "color: #aaa; background: #fff";
      document.querySelector("header")?.append(button, text);
    });
    expect((await findings(page)).map((finding) => finding.split(":")[0])).toEqual(expect.arrayContaining(["button-name", "color-contrast"]));
  });

  it("finds nothing in the first view", async () => {
    await page.goto(`${fixture.url}/pro/`);
    await page.getByRole("button", { name: "Load" }).waitFor();
    expect(await inBothThemes()).toEqual([]);
  });

  it("finds nothing in a run, its derivation, services and cell", async () => {
    await page.getByRole("combobox", { name: "Document" }).selectOption("pick");
    await page.getByRole("button", { name: "Load" }).click();
    await page.getByRole("group", { name: "State Pick/Release" }).waitFor();
    await settled(page);
    expect(await inBothThemes()).toEqual([]);

    await letMove(page, "pick");
    await page.getByRole("button", { name: "Start" }).click();
    await expect.poll(() => page.getByRole("status", { name: "Run status" }).innerText(), { timeout: 90_000 }).toContain("Ended");
    await showStep(page, 1);
    await (await reachNode(page, /^PTrans1/)).locator(".proof-row").first().click();
    expect(await inBothThemes()).toEqual([]);

    await page.getByRole("group", { name: "State Pick/Release" }).click({ position: { x: 20, y: 8 } });
    expect(await inBothThemes()).toEqual([]);

    // The step that was picked is past: there, nothing in the cell can be done.
    await page.getByRole("button", { name: "Now", exact: true }).click();
    await tab("Services");
    await page.locator(".service").first().waitFor();
    expect(await inBothThemes()).toEqual([]);

    await tab("Cell");
    await page.getByRole("button", { name: "Parts" }).click();
    await page.getByRole("list", { name: "Parts" }).waitFor();
    expect(await inBothThemes()).toEqual([]);
  });

  it("finds nothing in the help", async () => {
    await page.keyboard.press("?");
    await page.getByRole("dialog").waitFor();
    expect(await inBothThemes()).toEqual([]);
    await page.keyboard.press("Escape");
  });

  it("finds nothing in the documents and their forms", async () => {
    await page.getByRole("button", { name: "Documents" }).click();
    const row = page.getByRole("dialog", { name: "Documents" }).getByRole("listitem", { name: "pick", exact: true });
    await row.getByRole("button", { name: "Duplicate" }).click();
    await row.getByRole("textbox").waitFor();
    expect(await inBothThemes()).toEqual([]);
    await page.keyboard.press("Escape");
    await row.getByRole("button", { name: "Delete" }).click();
    await row.getByRole("group").waitFor();
    expect(await inBothThemes()).toEqual([]);
  });

  it("finds nothing on a display", async () => {
    const display = await fixture.openPage({ width: 390, height: 844 });
    await display.goto(`${fixture.url}/display/?name=phone`);
    await display.getByRole("main").waitFor();
    expect(await inBothThemes(display)).toEqual([]);
    await display.close();
  });

  it("finds nothing on the page that edits a document", async () => {
    await page.goto(`${fixture.url}/pro/?edit=pick`);
    await settled(page);
    expect(await inBothThemes()).toEqual([]);
    await page.getByRole("group", { name: "State Pick/Release" }).click({ position: { x: 20, y: 8 } });
    expect(await inBothThemes()).toEqual([]);
  });

  it("finds nothing on a draft with errors", async () => {
    await fixture.send("PUT", "/documents/draft?draft=true", { rcm: 1, root: { state: "Root", first: "A", children: [{ state: "A", ports: [{ name: "done", when: "1 +", to: "Nowhere" }] }] } });
    await page.goto(`${fixture.url}/pro/?edit=draft`);
    await page.getByRole("region", { name: "Errors" }).waitFor();
    expect(await inBothThemes()).toEqual([]);
  });

  it("finds nothing in the arguments of a run", async () => {
    await page.goto(`${fixture.url}/pro/`);
    await page.getByRole("combobox", { name: "Document" }).selectOption("pick");
    await page.getByRole("button", { name: "Arguments…" }).click();
    await page.getByRole("dialog", { name: /^Arguments/ }).waitFor();
    expect(await inBothThemes()).toEqual([]);
    await page.keyboard.press("Escape");
  });

  it("finds nothing in the forms, the state editor, menus, the command palette and notes of the page that edits", async () => {
    const document = {
      rcm: 1, name: "forms",
      library: [{ state: "Part", ports: [{ name: "done", when: "True" }] }],
      root: {
        state: "Root", first: "A", parameters: [{ name: "way", value: [0.5, 1], type: { list: "number" }, unit: "m", doc: "How far" }], results: [{ name: "pose", type: "pose" }], variables: [{ name: "count", initial: 0 }],
        actions: [{ when: "chi.A.port.done", do: "var.count += 1" }], entry: "pass", oracle: { kind: "history" }, ports: [{ name: "done", when: "chi.A.port.done" }, { name: "late", after: "10.0" }],
        children: [{ state: "A", keep: ["done"], meta: { id: "a" }, ports: [{ name: "done", when: "1 +", to: "Both" }] }, { barrier: "Both", to: ["L"] }, { state: "L", link: "Part" }],
      },
      meta: { notes: { a: "Ask Ann about the new gripper." } },
    };
    await fixture.send("PUT", "/documents/forms?draft=true", document);
    await page.goto(`${fixture.url}/pro/?edit=forms`);
    await settled(page);
    const row = (path: string) => page.locator(`[role="tree"] [data-path="${path}"] .tree-name`);
    for (const path of ["Root", "Root/A", "Root/Both", "Root/L"]) {
      await row(path).click();
      await page.getByRole("complementary", { name: "Properties" }).getByRole("textbox", { name: "Name", exact: true }).first().waitFor();
      await settled(page);
      expect.soft(await inBothThemes(), path).toEqual([]);
    }
    await row("Root").click();
    await page.getByRole("button", { name: "Wide form" }).click();
    await page.getByRole("region", { name: "State editor: Root" }).waitFor();
    await settled(page);
    expect.soft(await inBothThemes(), "state editor").toEqual([]);
    await page.keyboard.press("Escape");
    await page.locator("#edit-canvas").focus();
    await page.keyboard.press("Shift+F10");
    await page.getByRole("menu", { name: "Actions" }).waitFor();
    expect.soft(await inBothThemes(), "menu").toEqual([]);
    await page.keyboard.press("Escape");
    await page.keyboard.press("Control+Shift+P");
    await page.getByRole("dialog", { name: "Commands" }).waitFor();
    expect.soft(await inBothThemes(), "palette").toEqual([]);
    await page.keyboard.press("Escape");
    await page.locator("#edit-canvas").focus();
    await page.keyboard.press("F2");
    await page.getByRole("textbox", { name: "Name of Root" }).fill("2nd");
    await page.keyboard.press("Enter");
    await page.locator("#name-reason").waitFor();
    expect.soft(await inBothThemes(), "name").toEqual([]);
    await page.keyboard.press("Escape");
  });
});
