// The calls and events of a run: what was called, what came, what was forced, each a way to its micro step.
import { findings } from "./axe";
import { openFixture, settled, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
  fixture.page.setDefaultTimeout(kPatience);
});
afterAll(() => fixture.close());

const list = () => fixture.page.getByRole("region", { name: "Calls and events" });
const entries = async () => (await list().getByRole("listitem").allInnerTexts()).map((text) => text.replace(/\s+/g, " "));

/** Calls the database, then the timer; ends when `n` is forced. */
const root = {
  state: "Root",
  variables: [{ name: "n", initial: 0 }],
  first: "Ask",
  children: [
    { state: "Ask", entry: 'svc.db.get("nothing")', ports: [{ name: "missing", when: "svc.db.get.error", to: "Wait" }] },
    { state: "Wait", entry: "svc.timer.start(0.05)", ports: [{ name: "done", when: "svc.timer.start.result", to: "Stay" }] },
    { state: "Stay" },
  ],
  ports: [{ name: "forced", when: "var.n > 2" }],
};

describe("the calls and events of a run", () => {
  let id = "";

  it("are listed in their order, with a forced value", async () => {
    const { page } = fixture;
    await fixture.send("PUT", "/documents/asking", { rcm: 1, name: "asking", root });
    id = ((await fixture.send("POST", "/cores", { document: "asking" })) as { readonly id: string }).id;
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(page);
    await page.getByRole("tab", { name: "Calls and events" }).click();
    await expect.poll(() => list().innerText(), kSoon).toContain("appear here with its first step");
    await fixture.send("POST", `/cores/${id}/start`);
    await expect.poll(async () => (await entries()).join("\n"), kSoon).toContain("timer.start →");
    await fixture.send("POST", `/cores/${id}/force`, { path: "Root", scope: "var", name: "n", value: 3 });
    await expect.poll(async () => (await entries()).at(-1), kSoon).toContain("force Root var.n = 3");
    // An entry is drawn, and has a text, a frame later.
    const texts = async () => (await entries()).filter((text) => !text.includes("event")).map((text) => text.replace(/^\S+ /, ""));
    await expect.poll(async () => (await texts()).slice(0, 6), kSoon).toEqual([
      "start",
      "call db.get('nothing')",
      expect.stringMatching(/^response db\.get ✕ .*not_found/),
      "call timer.start(0.05)",
      expect.stringMatching(/^response timer\.start →/),
      "force Root var.n = 3",
    ]);
    await fixture.screenshot("calls");
    expect(await findings(page)).toEqual([]);
  });

  it("have what was forced in the log, too, with when and a way there", async () => {
    const { page } = fixture;
    await page.getByRole("tab", { name: "Log" }).click();
    const forced = page.locator(".log-line").filter({ hasText: "forced: Root var.n = 3" });
    await expect.poll(() => forced.locator("time").innerText(), kSoon).toMatch(/^\d+\.\d{3} s$/);
    const lines = () => page.locator(".log-line span").allInnerTexts();
    await expect.poll(async () => (await lines()).find((_, i, all) => all[i - 1] === "asking: running"), kSoon).toMatch(/^forced/);
    await fixture.screenshot("log-forced");
    await forced.getByRole("button").click();
    await expect.poll(() => list().locator('[aria-current="step"]').innerText(), kSoon).toContain("Root var.n = 3");
    await page.keyboard.press("Escape");
  });

  it("are filtered by kind, service and text", async () => {
    const { page } = fixture;
    await list().getByLabel("Kind").selectOption("Calls");
    await expect.poll(() => list().getByRole("listitem").count(), kSoon).toBe(2);
    await list().getByLabel("Service", { exact: true }).selectOption("db");
    await expect.poll(() => list().getByRole("listitem").count(), kSoon).toBe(1);
    await list().getByLabel("Kind").selectOption("All kinds");
    await list().getByRole("searchbox").fill("not_found");
    await expect.poll(entries, kSoon).toEqual([expect.stringContaining("response")]); // an entry is drawn, and has a text, a frame later
    await list().getByRole("searchbox").fill("nobody");
    await page.getByText("No entry fits this filter.").waitFor();
    await list().getByRole("searchbox").fill("");
  });

  it("lead to their micro step", async () => {
    const { page } = fixture;
    await list().getByRole("button", { name: /db\.get\('nothing'\)/ }).click();
    await expect.poll(() => new URL(page.url()).searchParams.get("at"), kSoon).toMatch(/^1\.\d+$/);
    await expect.poll(() => list().locator('[aria-current="step"]').innerText(), kSoon).toContain("db.get('nothing')");
    await expect.poll(() => page.locator('.canvas [data-path="Root/Ask"]').first().getAttribute("data-active"), kSoon).toBe("true");
  });

  it("are there of a stored run, too", async () => {
    const { page } = fixture;
    await page.goto("about:blank"); // it may still ask for steps of the core
    await fixture.send("DELETE", `/cores/${id}`);
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(page);
    await page.getByRole("tab", { name: "Calls and events" }).click();
    await expect.poll(async () => (await entries()).join("\n"), kSoon).toContain("force Root var.n = 3");
  });
});
