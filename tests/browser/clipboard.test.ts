// Copy, cut and paste on the real server: numbers stay as they are written, and the text is one that an editor takes.
import { editPage, kTask, middle } from "./editPage";
import { openFixture, settled, type Fixture } from "./fixture";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
  await fixture.page.context().grantPermissions(["clipboard-read", "clipboard-write"], { origin: fixture.url });
});
afterAll(() => fixture.close());

const text = async (name: string) => (await fetch(`${fixture.url}/api/v1/documents/${name}`)).text();
const clipboard = () => fixture.page.evaluate(() => navigator.clipboard.readText());

/** A state with the parameter 1.0, as text: JSON.stringify would write 1. */
const kExact = JSON.stringify({ rcm: 1, root: { state: "Root", first: "A", children: [{ state: "A", parameters: [{ name: "width", value: "NUMBER" }] }] } }).replace('"NUMBER"', "1.0");

describe("the clipboard", () => {
  it("keeps numbers as they are written, from one document to another", async () => {
    const { open, select, told } = editPage(fixture);
    await fetch(`${fixture.url}/api/v1/documents/exact`, { method: "PUT", body: kExact, headers: { "content-type": "application/json" } });
    await fixture.page.goto(`${fixture.url}/pro/?edit=exact`);
    await settled(fixture.page);
    await select("Root/A");
    await fixture.page.keyboard.press("Control+c");
    await told.getByText("Copied").waitFor();
    await expect.poll(() => clipboard()).toContain('"value": 1.0');
    await open("other");
    await select("Root/A");
    await fixture.page.keyboard.press("Control+v");
    await expect.poll(() => text("other")).toMatch(/"value":\s*1\.0/);
  });

  it("cuts, and says why another text is none", async () => {
    const { open, select, told, children } = editPage(fixture);
    await open("cut", kTask);
    await select("Root/C");
    await fixture.page.keyboard.press("Control+x");
    await expect.poll(() => children("cut")).toEqual(["A", "B", "Both"]);
    await fixture.page.evaluate(() => navigator.clipboard.writeText('{"state": 3}'));
    await fixture.page.keyboard.press("Control+v");
    await told.getByText("children/0").waitFor();
    expect(await children("cut")).toEqual(["A", "B", "Both"]);
  });
});

describe("the left panel", () => {
  it("gives states by drag and by Enter, and links to library states", async () => {
    const { open, state } = editPage(fixture);
    await open("library", { ...kTask, library: [{ state: "Pick", ports: [{ name: "done", when: "True" }] }] });
    const item = fixture.page.getByRole("button", { name: "State", exact: true });
    const [from, to] = [await item.boundingBox(), await middle(fixture.page, '#edit-canvas [data-path="Root/C/D"] .state-name')];
    await fixture.page.mouse.move((from?.x ?? 0) + 10, (from?.y ?? 0) + 10);
    await fixture.page.mouse.down();
    await fixture.page.mouse.move(to.x, to.y, { steps: 6 });
    await fixture.screenshot("edit-drop");
    await fixture.page.mouse.up();
    await expect.poll(async () => (await state("library", "C"))?.children?.map((child) => child.state)).toEqual(["D", "State"]);
    await fixture.page.getByRole("button", { name: "Barrier", exact: true }).focus();
    await fixture.page.keyboard.press("Enter");
    await fixture.page.getByRole("button", { name: "Actions of Pick" }).click();
    await fixture.page.getByRole("menuitem", { name: "Link here" }).click();
    const inside = async () => (await state("library", "C"))?.children?.map((child) => child.link ?? child.state ?? child.barrier);
    await expect.poll(inside).toEqual(["D", "State", "Barrier", "Pick"]);
    await fixture.screenshot("edit-library");
  });

  it("gets a state that is extracted into the library, under the name that is asked; the state becomes a link, until that is undone", async () => {
    const { open, node, stored, state } = editPage(fixture);
    const { page } = fixture;
    await open("extracted");
    await settled(page);
    await node("Root/C").click({ button: "right", position: { x: 20, y: 8 } });
    await page.getByRole("menuitem", { name: /^Extract into the library/ }).click();
    const name = page.getByRole("textbox", { name: "Name in the library" });
    await name.fill("Part");
    await name.press("Enter");
    await expect.poll(async () => (await stored("extracted")).library?.map((each) => [each.state, each.children?.map((child) => child.state)])).toEqual([["Part", ["D"]]]);
    expect((await stored("extracted")).root.children?.map((child) => [child.state ?? child.barrier, child.link])).toEqual([["A", undefined], ["B", undefined], ["C", "Part"], ["Both", undefined]]);
    await expect.poll(() => page.getByRole("region", { name: "Library" }).getByRole("listitem").allInnerTexts()).toEqual([expect.stringMatching(/^Part\s+1 link/)]);
    await settled(page);
    await fixture.screenshot("edit-extracted");
    await page.keyboard.press("Control+z");
    await expect.poll(async () => [(await state("extracted", "C"))?.children?.map((child) => child.state), (await stored("extracted")).library ?? []]).toEqual([["D"], []]);
  });
});
