// RACE-One: a field for labels of parts offers what the camera sees now, on a server whose documents name none. On the real server.
import { cpSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { findings } from "./axe";
import { demo, openFixture, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

interface StateJson {
  readonly state: string;
  readonly link?: string;
  readonly parameters?: readonly { readonly name: string; readonly value?: unknown }[];
  readonly children?: readonly StateJson[];
}

const kApplication = "sorting";
/** What stands on the table of the demo; the tool of the arm is a part, too, and may be seen. */
const kParts = ["Bar", "Block", "Box", "Cube", "Tape"];

const cell = mkdtempSync(join(tmpdir(), "race-cell-"));
let fixture: Fixture;
let page: Page;
beforeAll(async () => {
  cpSync(demo, cell, { recursive: true, filter: (path) => !/(?:demonstrator|pick)\.rcm\.json$/.test(path) });
  fixture = await openFixture("--demo", cell);
  page = await (await fixture.openContext({ viewport: { width: 1366, height: 900 }, reducedMotion: "reduce", colorScheme: "light" })).newPage();
  page.setDefaultTimeout(kPatience);
  const one = {
    state: "FindOne", doc: "Finds one part.", ports: [{ name: "success", when: "True" }], meta: { skill: true, title: "Find one", category: "vision" },
    parameters: [{ name: "label", value: "", type: "string", doc: "Which part.", meta: { domain: "label", title: "Part" } }],
  };
  await fixture.send("PUT", "/documents/finders", { rcm: 1, name: "finders", root: { state: "Application" }, library: [one] });
  await fixture.send("PUT", `/documents/${kApplication}`, { rcm: 1, name: kApplication, root: { state: "Application", meta: { id: "root" } } });
  await page.goto(`${fixture.url}/one/?edit=${kApplication}`);
  await page.getByLabel("Name of the task").fill("Sort");
  await page.getByRole("button", { name: "Add the task" }).click();
});
afterAll(async () => {
  await fixture.close();
  rmSync(cell, { recursive: true, force: true });
});

const panel = () => page.getByRole("complementary", { name: "What is selected" });
const field = (title: string) => panel().getByRole("group", { name: title, exact: true });
const seen = () => panel().getByRole("group", { name: "Seen now", exact: true });
const says = (text: string) => expect.poll(() => seen().getByRole("status").innerText(), kSoon).toBe(text);
const seenLabels = async () => (await seen().locator(".chip").allInnerTexts()).filter((label) => label !== "Tool");
const calls = (operations: string[]) => page.on("request", (request) => {
  if (request.url().endsWith("/services/obj_rec/calls")) operations.push((request.postDataJSON() as { readonly operation: string }).operation);
});

/** A value of the step of a skill, as the document on the server has it: the step's own, else the library's. */
async function stored(skill: string, name: string): Promise<unknown> {
  const { document } = (await fixture.send("GET", `/documents/${kApplication}`)) as { readonly document: { readonly root: StateJson; readonly library?: readonly StateJson[] } };
  const step = document.root.children?.flatMap(({ children = [] }) => children).find(({ link }) => link === skill);
  const find = (state: StateJson | undefined) => state?.parameters?.find((each) => each.name === name && each.value !== undefined);
  return (find(step) ?? find(document.library?.find(({ state }) => state === skill)))?.value;
}

describe("the field of several labels", () => {
  const asked: string[] = [];

  it("offers what stands on the table, as seen now, when it opens", async () => {
    calls(asked);
    await page.locator('[data-skill="SearchObject"]').click();
    await says("Seen now");
    await expect.poll(seenLabels, kSoon).toEqual(kParts);
    await field("Parts").getByRole("checkbox", { name: "Tool", exact: true }).waitFor(); // seen, too, or else known to the service
    await expect.poll(() => field("Parts").getByRole("checkbox").count(), { ...kSoon, message: "each once" }).toBe(kParts.length + 1);
    await fixture.screenshot("one-seen-labels", page);
    expect(await findings(page)).toEqual([]);
  });

  it("asks the camera once, and not again and again", async () => {
    await page.waitForTimeout(1500);
    expect(asked.sort()).toEqual(["labels", "look"]);
  });

  it("stores what is chosen", async () => {
    await seen().getByRole("checkbox", { name: "Cube", exact: true }).check();
    await expect.poll(() => stored("SearchObject", "labels"), kSoon).toEqual(["Cube"]);
    await seen().getByRole("checkbox", { name: "Tape", exact: true }).check();
    await expect.poll(() => stored("SearchObject", "labels"), kSoon).toEqual(["Cube", "Tape"]);
  });

  it("looks again at a press: what was taken away is offered still, but is not seen", async () => {
    await fixture.send("POST", "/cell/person", { act: "take", part: "can_yellow" });
    await seen().getByRole("button", { name: "Look again" }).click();
    await expect.poll(seenLabels, kSoon).toEqual(kParts.filter((label) => label !== "Tape"));
    expect(await field("Parts").getByRole("checkbox", { name: "Tape", exact: true }).isChecked()).toBe(true);
    expect(asked.filter((operation) => operation === "look")).toHaveLength(2);
  });

  it("says why the camera does not tell, and stays usable", async () => {
    await page.route("**/services/obj_rec/calls", async (route, request) => {
      if ((request.postDataJSON() as { readonly operation: string }).operation !== "look") return route.continue();
      return route.fulfill({ json: { error: { code: "no_picture", message: "no picture has come from the camera" } } });
    });
    await seen().getByRole("button", { name: "Look again" }).click();
    await says("It is not known what the camera sees: no picture has come from the camera.");
    await expect.poll(() => seenLabels(), kSoon).toEqual([]);
    expect(await field("Parts").getByRole("checkbox", { name: "Box", exact: true }).count(), "the service knows it").toBe(1);
    await field("Parts").getByRole("textbox").fill("Gear");
    await field("Parts").getByRole("button", { name: "Add" }).click();
    await expect.poll(() => stored("SearchObject", "labels"), kSoon).toEqual(["Cube", "Tape", "Gear"]);
    expect(await findings(page)).toEqual([]);
    await page.unroute("**/services/obj_rec/calls");
  });
});

describe("the field of one label", () => {
  it("takes one that is seen by a press, and any other that is typed", async () => {
    await page.locator('[data-skill="FindOne"]').click();
    await panel().getByLabel("Part", { exact: true }).waitFor();
    await says("Seen now");
    await seen().getByRole("radio", { name: "Block", exact: true }).check();
    await expect.poll(() => stored("FindOne", "label"), kSoon).toBe("Block");
    const box = panel().getByLabel("Part", { exact: true });
    await expect.poll(() => box.inputValue(), kSoon).toBe("Block");
    await box.fill("Gear");
    await box.press("Enter");
    await expect.poll(() => stored("FindOne", "label"), kSoon).toBe("Gear");
    await expect.poll(() => seen().getByRole("radio", { checked: true }).count(), kSoon).toBe(0);
    expect(await findings(page)).toEqual([]);
  });
});
