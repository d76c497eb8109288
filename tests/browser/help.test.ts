// The help, on the real server: found by keys, by its address and from an error; its examples are tasks that run; the tour ends with an own state that has run.
import { findings } from "./axe";
import { editPage, write } from "./editPage";
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
const help = () => fixture.page.getByRole("dialog", { name: "Help" });
const article = (title: string) => help().getByRole("article", { name: title });
const query = (key: string) => new URL(fixture.page.url()).searchParams.get(key);
const tour = () => fixture.page.getByRole("complementary", { name: "Tour" });
const step = () => tour().locator('[aria-current="step"]').innerText();

describe("the help", () => {
  it("is opened by F1, searched, and shown by its address", async () => {
    const { page, url } = fixture;
    await page.goto(`${url}/pro/`);
    await page.getByRole("button", { name: "Help", exact: true }).waitFor();
    await page.keyboard.press("F1");
    await article("What RACE is").waitFor();
    await help().getByRole("searchbox").fill("quaternion");
    await page.keyboard.press("Enter");
    await article("Module geo").waitFor();
    await soon(() => query("help")).toBe("language-geo");
    await page.reload();
    await article("Module geo").waitFor();
    await page.keyboard.press("Escape");
    await soon(() => help().count()).toBe(0);
    await soon(() => query("help")).toBe(null);
  });

  it("draws its figures, and has no serious findings in either theme", async () => {
    const { page, url } = fixture;
    for (const scheme of ["light", "dark"] as const) {
      await page.emulateMedia({ colorScheme: scheme });
      await page.goto(`${url}/pro/?help=barriers`);
      await soon(() => help().locator(".svg-state").count()).toBe(5);
      await fixture.screenshot(`help-${scheme}`);
      expect(await findings(page)).toEqual([]);
    }
    await page.emulateMedia({ colorScheme: "light" });
    await page.goto(`${url}/pro/?help=keys`);
    await article("Keys and mouse").getByText("Group into a new state").waitFor();
    expect(await findings(page)).toEqual([]);
  });

  it("has examples that are documents without errors", async () => {
    const { page, url, send } = fixture;
    const names = { state: "grasp", hierarchy: "pick-example", ports: "choice-example", barriers: "barrier-example", values: "values-example", oracles: "history-example", time: "time-out-example" };
    for (const [topic, name] of Object.entries(names)) {
      await page.goto(`${url}/pro/?help=${topic}`);
      await help().getByRole("button", { name: "Open as a document of your own" }).click();
      await soon(() => query("edit")).toBe(name);
      const { errors } = (await send("GET", `/documents/${name}`)) as { readonly errors: readonly object[] };
      expect([name, errors]).toEqual([name, []]);
    }
  });

  it.each([["choice-example", "done"], ["values-example", "done"], ["barrier-example", "done"], ["history-example", "done"]])("has examples that run to their end: %s", async (name, outcome) => {
    const { send } = fixture;
    const { id } = (await send("POST", "/cores", { document: name, arguments: {} })) as { readonly id: string };
    await send("POST", `/cores/${id}/start`);
    await soon(async () => {
      const { status, outcome: how } = (await send("GET", `/cores/${id}`)) as { readonly status: string; readonly outcome?: string };
      return [status, how];
    }).toEqual(["ended", outcome]);
  });
});

describe("the tour", () => {
  it("ends with an own state that has run", async () => {
    const { page, url } = fixture;
    await page.goto(`${url}/pro/?help=start`);
    await help().getByRole("button", { name: "Start the tour" }).click();
    await soon(step).toBe("Add a state");
    await settled(page);
    await soon(() => query("tour")).toBe("first-task");
    await page.locator("#edit-canvas").focus();
    await page.keyboard.press("Insert");
    await soon(step).toBe("Let it do something");
    await page.keyboard.press("F2");
    await page.keyboard.type("Hello");
    await page.keyboard.press("Enter");
    const { select, node } = editPage(fixture);
    await node("first_task/Hello").waitFor();
    const properties = page.getByRole("complementary", { name: "Properties" });
    await write(properties.getByRole("textbox", { name: "Entry" }), 'print("hello")');
    await page.keyboard.press("Control+Enter");
    await soon(step).toBe("Give it a way out");
    await fixture.screenshot("tour");
    await properties.getByRole("button", { name: "Add port" }).click();
    await write(properties.getByRole("textbox", { name: "Condition" }), "True");
    await page.keyboard.press("Control+Enter");
    await soon(step).toBe("Let the task end");
    await select("first_task");
    await properties.getByRole("button", { name: "Add port" }).click();
    await write(properties.getByRole("textbox", { name: "Condition" }), "chi.Hello.port.success");
    await page.keyboard.press("Control+Enter");
    await soon(step).toBe("Make a run");
    await soon(() => page.locator(".edit-head [role=status]").innerText()).toContain("saved");
    await page.reload();
    await soon(step).toBe("Make a run");
    await settled(page);
    await page.locator("#edit-canvas").focus();
    await page.keyboard.press("F5");
    await soon(step).toBe("Start it");
    await page.getByRole("toolbar", { name: "Run" }).getByRole("button", { name: "Start" }).click();
    await tour().getByText("Your task has run.").waitFor();
    await page.getByRole("tab", { name: "Log" }).click();
    await page.getByRole("log").getByText("hello").first().waitFor();
    await tour().getByRole("button", { name: "End the tour" }).click();
    await soon(() => query("tour")).toBe(null);
  });
});
