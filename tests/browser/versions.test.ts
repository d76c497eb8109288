// The history of a document, on the real server: who changed it and when, what differs, as text and in the drawing, restoring and branching.
import { findings } from "./axe";
import { editPage } from "./editPage";
import { openFixture, settled, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
  fixture.page.setDefaultTimeout(kPatience);
  await fixture.page.setViewportSize({ width: 1366, height: 768 });
});
afterAll(() => fixture.close());

const soon = (value: () => unknown) => expect.poll(value, kSoon);
const panel = () => fixture.page.getByRole("region", { name: "History" });
const row = (number: string) => panel().locator(".revision-row").filter({ has: fixture.page.locator(`b:text-is("${number}")`) });
const changes = () => panel().getByRole("list", { name: "Changes" }).getByRole("button").allInnerTexts();
const words = async () => (await changes()).map((text) => text.replace(/\s+/g, " ").trim());
const query = (key: string) => new URL(fixture.page.url()).searchParams.get(key);
const marks = () => fixture.page.locator(".difference-mark").evaluateAll((all) => all.map((mark) => mark.textContent));
const edit = (name: string, revision: number, operations: readonly object[], author = "Bob~q1") =>
  fixture.send("POST", `/documents/${name}/edits`, { request: `r-${revision}`, revision, author, operations });

interface StateJson {
  readonly state: string;
  readonly meta: { readonly id: string };
  readonly children: readonly StateJson[];
}
/** Ids of the root and of its children, by name. */
async function ids(name: string): Promise<ReadonlyMap<string, string>> {
  const { root } = (await editPage(fixture).stored(name)) as unknown as { readonly root: StateJson };
  return new Map([root, ...root.children].map(({ state, meta: { id } }) => [state, id]));
}

/** Revision 1: the task; Bob, in 2: C has a doc; in 3: B is gone; in 4: that is undone. */
async function openTask(name: string): Promise<ReadonlyMap<string, string>> {
  await editPage(fixture).open(name);
  const all = await ids(name);
  await edit(name, 1, [{ op: "set", id: all.get("C"), field: "doc", value: "waits" }]);
  await edit(name, 2, [{ op: "remove", id: all.get("B") }]);
  return all;
}

describe("the history of a document", () => {
  it("is listed, with who, when and what, and follows what others do", async () => {
    await openTask("listed");
    await fixture.page.keyboard.press("Control+Shift+H");
    await row("2 to 3").waitFor();
    await soon(() => row("2 to 3").innerText()).toMatch(/2 edits[\s\S]*Bob, just now/);
    await soon(() => row("1").innerText()).toContain("stored as a whole");
    await soon(() => query("versions")).toBe("list");
    await fixture.send("POST", "/documents/listed/edits", { request: "u-1", revision: 3, author: "Bob~q1", undo: true });
    await row("2 to 4").waitFor();
    await soon(() => row("2 to 4").innerText()).toContain("3 edits, 1 of them undo");
  });

  it("says what has changed since a revision, as text and in the drawing", async () => {
    await openTask("since");
    await fixture.page.getByRole("button", { name: "History" }).click();
    await row("1").click();
    await soon(words).toEqual(["− removed state Root/B", "≠ changed state Root/C doc: 'waits'"]);
    // What was removed is marked where it was.
    await soon(marks).toEqual(["−", "≠"]);
    const ghost = fixture.page.getByRole("img", { name: "Removed: state B" });
    await ghost.waitFor();
    expect(await ghost.locator("s").innerText()).toBe("B");
    await soon(async () => {
      const [inner, outer] = [await ghost.boundingBox(), await editPage(fixture).node("Root").boundingBox()];
      return inner !== null && outer !== null && inner.width * inner.height > 400 && inner.x > outer.x && inner.y > outer.y && inner.y < outer.y + outer.height + 200;
    }).toBe(true);
    await soon(() => row("1").getAttribute("aria-pressed")).toBe("true");
    await soon(() => query("versions")).toBe("1..");
    await fixture.screenshot("versions-light");
    expect(await findings(fixture.page)).toEqual([]);
  });

  it("says what one revision, and what a sitting has changed, also of what is not there any more", async () => {
    const all = await openTask("by");
    await edit("by", 3, [{ op: "remove", id: all.get("C") }]);
    await fixture.page.keyboard.press("Control+Shift+H");
    await fixture.page.getByRole("button", { name: "Revisions 2 to 4 one by one" }).click();
    await row("2").click();
    await panel().getByRole("radio", { name: "by it" }).check();
    await soon(words).toEqual(["≠ changed state Root/C doc: 'waits'"]);
    await soon(() => query("versions")).toBe("1..2");
    await panel().getByRole("radio", { name: "by 2 to 4" }).check();
    await soon(words).toEqual(["− removed state Root/B", "− removed state Root/C"]);
    await fixture.page.reload();
    await soon(words).toEqual(["− removed state Root/B", "− removed state Root/C"]);
    await soon(() => query("versions")).toBe("1..4");
  });

  it("leads from a change to its element, and to what is around one that is gone", async () => {
    await openTask("leads");
    await fixture.page.goto(`${fixture.url}/pro/?edit=leads&versions=1..`);
    const selected = () => fixture.page.getByRole("complementary", { name: "Properties" }).getByRole("textbox", { name: "Name" }).first().inputValue();
    await panel().getByRole("button", { name: "changed state Root/C" }).click();
    await soon(selected).toBe("C");
    await panel().getByRole("button", { name: "removed state Root/B" }).click();
    await soon(selected).toBe("Root");
  });

  it("restores a revision as a further one; nothing is lost", async () => {
    await openTask("restored");
    await fixture.page.goto(`${fixture.url}/pro/?edit=restored&versions=1..`);
    await panel().getByRole("button", { name: "Restore revision 1" }).click();
    await fixture.page.getByText("Revision 1 is restored, as revision 4.").waitFor();
    await editPage(fixture).node("Root/B").waitFor();
    expect(await editPage(fixture).children("restored")).toEqual(["A", "B", "C", "Both"]);
    await soon(() => panel().getByText("Nothing differs.").count()).toBe(1);
    await row("4").waitFor();
    await soon(() => row("4").innerText()).toContain("revision 1 restored");
    await row("2 to 3").click();
    await soon(words).toEqual(["+ added state Root/B", "≠ changed state Root/C doc: no longer 'waits'"]);
  });

  it("branches from a revision, and opens the branch", async () => {
    await openTask("origin");
    await fixture.page.goto(`${fixture.url}/pro/?edit=origin&versions=1..2`);
    await panel().getByRole("button", { name: "Branch…" }).click();
    await panel().getByRole("textbox").fill("twig");
    await fixture.page.keyboard.press("Enter");
    await soon(() => query("edit")).toBe("twig");
    await settled(fixture.page);
    expect(await editPage(fixture).children("twig")).toEqual(["A", "B", "C", "Both"]);
    expect((await editPage(fixture).state("twig", "C")) as object).toMatchObject({ doc: "waits" });
    await fixture.page.keyboard.press("Control+Shift+H");
    await soon(() => row("1").innerText()).toContain("branched from origin, revision 2");
  });

  it("is loaded in parts, is walked by arrows and closed by Esc", async () => {
    const all = await openTask("long");
    for (let revision = 3; revision < 130; revision++) await edit("long", revision, [{ op: "set", id: all.get("A"), field: "doc", value: `${revision}` }], `P${revision % 2}~q1`);
    await fixture.page.keyboard.press("Control+Shift+H");
    const count = () => panel().locator(".revision-row").count();
    await soon(count).toBe(100);
    await panel().getByRole("button", { name: "Older revisions" }).click();
    await row("1").waitFor();
    await row("130").focus();
    await fixture.page.keyboard.press("ArrowDown");
    await fixture.page.keyboard.press("Enter");
    await soon(() => query("versions")).toBe("129..");
    await fixture.page.keyboard.press("Escape");
    await soon(() => panel().count()).toBe(0);
    await soon(() => query("versions")).toBe(null);
  });
});
