// RACE-One: steps that are repeated until one of them says so, chosen in the form of the loop and run; and what is refused there. On the real server.
import { devices, type Page } from "playwright-core";
import { findings } from "./axe";
import { tap } from "./fingers";
import { openFixture, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

interface StateJson {
  readonly state: string;
  readonly parameters?: readonly { readonly name: string; readonly value?: unknown }[];
  readonly children?: readonly StateJson[];
  readonly ports?: readonly { readonly name: string; readonly when?: string }[];
}

const kApplication = "fill";

let fixture: Fixture;
let page: Page;
beforeAll(async () => {
  fixture = await openFixture();
  page = await (await fixture.openContext({ viewport: { width: 1366, height: 900 }, reducedMotion: "reduce", colorScheme: "light" })).newPage();
  page.setDefaultTimeout(kPatience);
  await fixture.send("PUT", `/documents/${kApplication}`, { rcm: 1, name: kApplication, root: { state: "Application", meta: { id: "root" } } });
  await page.goto(`${fixture.url}/one/?edit=${kApplication}`);
  await page.getByLabel("Name of the task").fill("Fill a box");
  await page.getByRole("button", { name: "Add the task" }).click();
});
afterAll(() => fixture.close());

const panel = (of = page) => of.getByRole("complementary", { name: "What is selected" });
const card = (title: string, of = page) => of.locator(".step > .card > .card-open", { has: of.locator("strong", { hasText: new RegExp(`^${title}$`) }) });
const until = () => panel().getByRole("checkbox", { name: "Until “Count” says “There are as many as wanted”" });

async function add(skill: string): Promise<void> {
  await page.locator(`[data-skill="${skill}"]`).click();
  await card({ WaitTime: "Wait", SearchObject: "Search a part", PickFound: "Pick the found part" }[skill] ?? skill).waitFor();
}

/** What is written: the ports of the loop and of what it repeats, by their conditions, and how often it repeats. */
async function written() {
  const { document } = (await fixture.send("GET", `/documents/${kApplication}`)) as { readonly document: { readonly root: StateJson } };
  const loop = document.root.children?.[0]?.children?.[0];
  const [body, count] = loop?.children ?? [];
  const when = (state: StateJson | undefined, name: string) => state?.ports?.find((port) => port.name === name)?.when;
  return { success: when(loop, "success"), done: when(body, "done"), times: count?.parameters?.find(({ name }) => name === "times")?.value };
}

it("is an outcome of a step that is repeated, as a choice beside how often", async () => {
  await add("Count");
  await panel().getByRole("textbox", { name: "How many" }).fill("2");
  await panel().getByRole("textbox", { name: "How many" }).press("Enter");
  await add("WaitTime");
  await panel().getByRole("textbox", { name: "Time", exact: true }).fill("0.5");
  await panel().getByRole("textbox", { name: "Time", exact: true }).press("Enter");
  await card("Count").click();
  await panel().getByLabel("Repeat from here to").selectOption({ label: "Wait" });
  await panel().getByRole("button", { name: "Repeat", exact: true }).click();
  await card("Repeat").getByText("3 ×").waitFor();
  await expect.poll(written, kSoon).toEqual({ success: "chi.Count.port.done", done: undefined, times: 3 });
  await until().check();
  await card("Repeat").getByText("until “There are as many as wanted”").waitFor();
  await expect.poll(written, kSoon).toEqual({ success: "chi.Count.port.done or chi.Body.port.done", done: "chi.Count.port.reached", times: 0 });
  await expect.poll(() => panel().getByRole("textbox", { name: "Times" }).count(), kSoon).toBe(0);
  await fixture.screenshot("one-until", page);
  expect(await findings(page)).toEqual([]);
});

it("is no more when the choice is taken back, and how often it repeats counts again", async () => {
  await until().uncheck();
  await card("Repeat").getByText("3 ×").waitFor();
  await panel().getByRole("textbox", { name: "Times" }).waitFor();
  await expect.poll(written, kSoon).toEqual({ success: "chi.Count.port.done", done: undefined, times: 3 });
  await page.getByRole("button", { name: "Undo" }).click();
  await card("Repeat").getByText("until “There are as many as wanted”").waitFor();
});

it("is chosen at the step, too, where it says what comes then, or what is done if it fails", async () => {
  await card("Count").click();
  const outcome = panel().getByRole("group", { name: "“There are as many as wanted”" });
  await expect.poll(() => outcome.getByRole("radio", { name: "End the loop" }).isChecked(), kSoon).toBe(true);
  await outcome.getByRole("radio", { name: "Go on with the next round" }).check();
  await card("Repeat").getByText("3 ×").waitFor();
  await outcome.getByRole("radio", { name: "End the loop" }).check();
  await card("Repeat").getByText("until “There are as many as wanted”").waitFor();
  await panel().getByRole("group", { name: "If it fails" }).getByRole("radio", { name: "End the loop" }).check();
  await card("Repeat").getByText("until “There are as many as wanted”, or until “Count” fails").waitFor();
  await card("Count").getByText("if it fails: end the loop").waitFor();
  await fixture.screenshot("one-until-step", page);
});

it("is refused where a step behind would lose the part that it takes, with what to do", async () => {
  await card("Wait").click();
  await add("SearchObject");
  await add("PickFound");
  await card("Search a part").click();
  const told = page.getByRole("status", { name: "What was said last" });
  await panel().getByRole("button", { name: "Repeat", exact: true }).click();
  await told.getByText('Not done: "Pick the found part" takes what "Search a part" gives: repeat both, or choose another "Part" there.').waitFor();
  await fixture.screenshot("one-refused", page);
  await panel().getByRole("button", { name: "Remove" }).click();
  await told.getByText('Not done: "Pick the found part" takes what "Search a part" gives: remove "Pick the found part" first, or choose another "Part" there.').waitFor();
  for (const title of ["Pick the found part", "Search a part"]) {
    await card(title).click();
    await panel().getByRole("button", { name: "Remove" }).click();
    await card(title).waitFor({ state: "detached" });
  }
});

it("ends the loop when it is run, and the run is done", async () => {
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await page.getByRole("heading", { name: "All done" }).waitFor();
  const outcomes = async () => ((await fixture.send("GET", "/cores")) as { readonly cores: readonly { readonly outcome?: string }[] }).cores.map(({ outcome }) => outcome);
  await expect.poll(outcomes, kSoon).toEqual(["success"]);
});

it("fits a phone, with choices that a finger hits", async () => {
  const phone = await (await fixture.openContext({ ...devices["Pixel 7"], reducedMotion: "reduce" })).newPage();
  await phone.goto(`${fixture.url}/one/?edit=${kApplication}`);
  await tap(card("Repeat", phone));
  const choice = panel(phone).locator("label", { hasText: "Until “Count” says" });
  await choice.waitFor();
  const box = await choice.boundingBox();
  expect(box?.height ?? 0).toBeGreaterThanOrEqual(43.5);
  await fixture.screenshot("one-until-phone", phone);
  expect(await findings(phone)).toEqual([]);
  expect(await phone.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
  await phone.context().close();
});
