// Proposed changes of documents, on the real server: seen without a reload, compared, accepted, declined with a reason, outdated, new documents.
import { findings } from "./axe";
import { editPage, kTask } from "./editPage";
import { openFixture, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
  fixture.page.setDefaultTimeout(kPatience);
  await fixture.page.setViewportSize({ width: 1366, height: 768 });
});
afterAll(() => fixture.close());

const soon = (value: () => unknown) => expect.poll(value, kSoon);
const query = (key: string) => new URL(fixture.page.url()).searchParams.get(key);
const panel = () => fixture.page.getByRole("dialog", { name: "Proposals" });
const count = () => fixture.page.getByRole("banner").locator(".proposals-button");
const row = (text: string) => panel().locator(".proposal-row").filter({ hasText: text });
const changes = async () => (await panel().getByRole("list", { name: "What it would change" }).getByRole("listitem").allInnerTexts()).map((text) => text.replace(/\s+/g, " ").trim());

interface Told {
  readonly id: string;
  readonly status: string;
  readonly reason?: string;
}
/** The task without B, and with a doc of C; ids are those of its revision. */
const kBetter = { ...kTask, root: { ...kTask.root, children: [{ state: "A", ports: [{ name: "done", when: "True" }] }, { state: "C", doc: "waits", first: "D", children: [{ state: "D" }] }, { barrier: "Both", to: ["C"] }] } };
const propose = async (name: string, document: object = kBetter, revision: number | null = 1, note = "B is never reached.") =>
  (await fixture.send("POST", `/documents/${name}/proposals?author=agent`, { document, revision, note })) as Told;
const told = async (id: string) => (await fixture.send("GET", `/proposals/${id}`)) as Told;

describe("a proposal", () => {
  it("is seen without a reload, with what it would change, and arrives on every page once it is accepted", async () => {
    await editPage(fixture).open("task");
    const other = await fixture.openPage();
    await other.goto(`${fixture.url}/pro/?edit=task`);
    await other.locator('#edit-canvas [data-path="Root/B"]').waitFor();
    expect(await count().count()).toBe(0);
    const { id } = await propose("task");
    await soon(() => count().allInnerTexts()).toEqual(["1 proposal"]);
    await count().click();
    expect(query("proposals")).toBe(id);
    await soon(changes).toEqual(["− removed state Root/B", "≠ changed port Root/A.done to: no longer 'B'", "≠ changed state Root/C doc: 'waits'"]);
    expect(await panel().innerText()).toMatch(/task, revision 1[\s\S]*agent, just now[\s\S]*B is never reached\./);
    const drawing = panel().getByRole("img", { name: "What it would change, in the drawing of task" });
    await drawing.waitFor();
    expect(await drawing.locator(".svg-ghost text").allTextContents()).toEqual(["B"]);
    expect((await drawing.locator(".svg-mark > text").allTextContents()).sort()).toEqual(["−", "≠", "≠"].sort());
    await fixture.screenshot("proposals-light");
    expect(await findings(fixture.page)).toEqual([]);
    await fixture.page.reload();
    await soon(changes).toHaveLength(3);
    await panel().getByRole("button", { name: "Accept" }).click();
    await panel().getByText(/It is accepted by .*, as revision 2\./).waitFor();
    await soon(() => count().count()).toBe(0);
    await other.locator('#edit-canvas [data-path="Root/B"]').waitFor({ state: "detached" });
    await editPage(fixture).node("Root/B").waitFor({ state: "detached" });
    expect(await editPage(fixture).children("task")).toEqual(["A", "C", "Both"]);
    await fixture.page.keyboard.press("Escape");
    await soon(() => query("proposals")).toBe(null);
    // Who has accepted it takes it back.
    await fixture.page.locator("#edit-canvas").click({ position: { x: 5, y: 5 } });
    await fixture.page.keyboard.press("Control+z");
    await soon(() => editPage(fixture).children("task")).toEqual(["A", "B", "C", "Both"]);
    await other.close();
  });

  it("is declined with a reason, by keys", async () => {
    await editPage(fixture).open("declined");
    await editPage(fixture).select("Root/C");
    const [{ id }] = [await propose("declined"), await propose("declined", kBetter, 1, "Once more.")];
    await soon(() => count().allInnerTexts()).toEqual(["2 proposals"]);
    await count().focus();
    await fixture.page.keyboard.press("Enter");
    expect(query("proposals")).toBe("list");
    await row("Once more.").focus();
    await fixture.page.keyboard.press("ArrowUp");
    await fixture.page.keyboard.press("Enter");
    await soon(() => query("proposals")).toBe(id);
    // Keys of the editor act on nothing below: this would remove what is selected there.
    await fixture.page.keyboard.press("Delete");
    await panel().getByRole("button", { name: "Decline…" }).focus();
    await fixture.page.keyboard.press("Enter");
    await fixture.page.keyboard.type("B is for later.");
    await fixture.page.keyboard.press("Tab");
    await fixture.page.keyboard.press("Enter");
    await panel().getByText("It is declined by").waitFor();
    expect(await told(id)).toMatchObject({ status: "declined", reason: "B is for later." });
    await soon(() => count().allInnerTexts()).toEqual(["1 proposal"]);
    expect(await editPage(fixture).children("declined")).toEqual(["A", "B", "C", "Both"]);
    await row("Once more.").click();
    await panel().getByRole("button", { name: "Decline…" }).click();
    await panel().getByRole("button", { name: "Decline it" }).click();
    await soon(() => count().count()).toBe(0);
    await fixture.page.keyboard.press("Escape");
    await soon(() => panel().count()).toBe(0);
  });

  it("says that it is outdated, and what to do", async () => {
    await editPage(fixture).open("outdated");
    const { id } = await propose("outdated");
    await soon(() => count().allInnerTexts()).toEqual(["1 proposal"]);
    await count().click();
    await soon(changes).toHaveLength(3);
    await fixture.send("PUT", "/documents/outdated", { rcm: 1, root: { state: "Other" } });
    await panel().getByText(/outdated has changed since revision 1: .* Decline it, so that agent proposes it anew/).waitFor();
    expect(await panel().getByRole("button", { name: "Accept" }).isDisabled()).toBe(true);
    expect(await row("outdated").innerText()).toContain("outdated");
    expect(await findings(fixture.page)).toEqual([]);
    await panel().getByRole("button", { name: "What has changed since revision 1" }).click();
    await fixture.page.getByRole("region", { name: "Comparison" }).getByRole("heading", { name: "Changed since revision 1" }).waitFor();
    expect([query("proposals"), query("versions")]).toEqual([null, "1.."]);
    await count().click();
    await fixture.send("DELETE", `/proposals/${id}`);
    await panel().getByText("It is withdrawn by").waitFor();
    await panel().getByText("No proposal waits for a decision.").waitFor();
    await fixture.page.keyboard.press("Escape");
  });

  it("of a new document shows what that has, and makes it", async () => {
    await fixture.page.goto(`${fixture.url}/pro/`);
    await propose("fresh", kTask, null, "A task of its own.");
    await count().click();
    await soon(changes).toContain("+ added state Root/C/D");
    await panel().getByRole("img", { name: "The states of fresh" }).waitFor();
    await panel().getByRole("heading", { name: "fresh, a new document" }).waitFor();
    await panel().getByRole("button", { name: "Accept" }).click();
    await panel().getByText("as revision 1.").waitFor();
    expect(await editPage(fixture).children("fresh")).toEqual(["A", "B", "C", "Both"]);
    await fixture.page.keyboard.press("Escape");
  });

  it("is counted beside its document, and its revision names both", async () => {
    await fixture.send("PUT", "/documents/beside", kTask);
    const { id } = await propose("beside");
    await fixture.page.goto(`${fixture.url}/pro/`);
    await count().waitFor();
    await fixture.page.keyboard.press("Control+o");
    await fixture.page.getByRole("dialog", { name: "Documents" }).getByRole("listitem", { name: "beside" }).getByRole("button", { name: "1 proposal" }).click();
    await soon(() => query("proposals")).toBe(id);
    await fixture.send("POST", `/proposals/${id}/accept?author=Ada`);
    await panel().getByText("It is accepted by Ada, as revision 2.").waitFor();
    await fixture.page.goto(`${fixture.url}/pro/?edit=beside&versions=list`);
    const revision = fixture.page.getByRole("region", { name: "History" }).locator(".revision-row").first();
    await soon(() => revision.innerText()).toMatch(/B is never reached\.[\s\S]*Ada, proposed by agent/);
  });
});
