// The form of each skill of the demo on the page of RACE-One: for each parameter the control that its type, unit, range and meaning ask for, which
// writes what is entered into the document on the server, and refuses what is outside. What is expected stands here, apart from the page's code.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Locator, Page } from "playwright-core";
import { findings } from "./axe";
import { demo, openFixture, type Fixture } from "./fixture";
import { kPatience } from "./patience";

type Json = null | boolean | number | string | readonly Json[] | { readonly [key: string]: Json };
interface ParameterJson {
  readonly name: string;
  readonly type: Json;
  readonly unit?: string;
  readonly doc?: string;
  readonly value?: Json;
  readonly from?: string;
  readonly meta: { readonly title?: string; readonly domain?: string; readonly min?: number; readonly max?: number; readonly step?: number; readonly choices?: readonly { readonly value: Json; readonly title: string }[]; readonly advanced?: boolean; readonly internal?: boolean };
}
interface StateJson {
  readonly state: string;
  readonly link?: string;
  readonly doc?: string;
  readonly parameters?: readonly ParameterJson[];
  readonly ports?: readonly { readonly name: string; readonly meta?: { readonly title?: string; readonly advice?: string } }[];
  readonly children?: readonly StateJson[];
  readonly meta: { readonly id: string; readonly skill?: boolean; readonly title?: string };
}
interface DocumentJson {
  readonly root: StateJson;
  readonly library: readonly StateJson[];
}

const skillsOf = ({ library }: DocumentJson): readonly StateJson[] => library.filter(({ meta }) => meta.skill === true);
/** As the server has it, too: the first test looks. */
const kSkills = skillsOf(JSON.parse(readFileSync(join(demo, "skills.rcm.json"), "utf8")) as DocumentJson);

const kApplication = "all-skills";
/** What a finger needs [px]; a pixel of the screen may be cut. */
const kTarget = 43.5;
const kSoon = { interval: 25, timeout: kPatience };

let fixture: Fixture;
let page: Page;
beforeAll(async () => {
  fixture = await openFixture();
  ({ page } = fixture);
  page.setDefaultTimeout(kPatience);
  await page.setViewportSize({ width: 1366, height: 900 });
  await page.emulateMedia({ reducedMotion: "reduce", colorScheme: "light" });
  await fixture.send("PUT", `/documents/${kApplication}`, { rcm: 1, name: kApplication, root: { state: "Application", meta: { id: "root" } } });
  await page.goto(`${fixture.url}/one/?edit=${kApplication}`);
  await page.getByLabel("Name of the task").fill("All skills");
  await page.getByRole("button", { name: "Add the task" }).click();
  await page.locator("[data-skill]").first().waitFor();
});
afterAll(() => fixture.close());

const documentOf = async (name: string): Promise<DocumentJson> => ((await fixture.send("GET", `/documents/${name}`)) as { readonly document: DocumentJson }).document;
const panel = () => page.getByRole("complementary", { name: "What is selected" });
const fieldOf = ({ name }: ParameterJson) => panel().locator(`[data-parameter="${name}"]`);
const titleOf = ({ meta, name }: ParameterJson): string => meta.title ?? name;

/** A parameter of the step that is selected, as the document on the server has it: the step's own, else the library's. */
async function onServer(name: string): Promise<ParameterJson | undefined> {
  const { root, library } = await documentOf(kApplication);
  const id = new URL(page.url()).searchParams.get("step");
  const step = root.children?.flatMap(({ children = [] }) => children).find(({ meta }) => meta.id === id);
  const find = (state: StateJson | undefined) => state?.parameters?.find((each) => each.name === name);
  const [own, below] = [find(step), find(library.find(({ state }) => state === step?.link))];
  return own === undefined ? below : ({ ...below, ...own } as ParameterJson);
}
const becomes = (name: string, value: unknown) => expect.poll(async () => (await onServer(name))?.value, { ...kSoon, message: name }).toEqual(value);

/** How a number is shown: in which unit, and how many of that one are one of the document. */
function shownAs({ unit, meta: { domain, max = Infinity } }: ParameterJson): { readonly unit: string; readonly factor: number } {
  if (domain === "speed") return { unit: "%", factor: 100 };
  if (unit === "m" && max <= 1) return { unit: "cm", factor: 100 };
  return { unit: unit ?? "", factor: 1 };
}

const inWords = (value: number): string => String(Math.round(value * 1e6) / 1e6);

async function enter(box: Locator, text: string): Promise<void> {
  await box.fill(text);
  await box.press("Enter");
}

/** A box of a number, with a slider where its steps can be hit: each sets one end of the range. */
async function checkNumber(parameter: ParameterJson): Promise<void> {
  const { min = Number.NaN, max = Number.NaN, step = Number.NaN } = parameter.meta;
  const { unit, factor } = shownAs(parameter);
  const field = fieldOf(parameter);
  const box = field.getByRole("textbox", { name: titleOf(parameter), exact: true });
  const slider = field.getByRole("slider");
  const isWhole = parameter.type === "int";
  const hasSlider = (max - min) / step <= (isWhole ? 20 : 2000);
  expect(await slider.count(), parameter.name).toBe(hasSlider ? 1 : 0);
  expect(await field.getByRole("button").count(), parameter.name).toBe(!hasSlider && isWhole ? 2 : 0);
  if (unit !== "") expect(await field.locator(".number-entry > span").innerText()).toBe(unit);
  const range = `This has to be ${`${inWords(min * factor)} ${unit}`.trim()} to ${`${inWords(max * factor)} ${unit}`.trim()}`;
  const refused: readonly (readonly [string, string])[] = [
    [inWords((min - step) * factor), range],
    [inWords((max + step) * factor), range],
    ["many", "This has to be a number"],
    ...(isWhole ? [[`${min}.5`, "This has to be a whole number"] as const] : []),
  ];
  const before = (await onServer(parameter.name))?.value;
  for (const [text, why] of refused) {
    await enter(box, text);
    await expect.poll(() => field.getByRole("alert").innerText(), { ...kSoon, message: `${parameter.name}: ${text}` }).toBe(why);
    expect(await box.getAttribute("aria-invalid")).toBe("true");
  }
  expect((await onServer(parameter.name))?.value).toEqual(before);
  await enter(box, inWords(min * factor));
  await becomes(parameter.name, min);
  await expect.poll(() => field.getByRole("alert").count(), kSoon).toBe(0);
  if (hasSlider) {
    await slider.focus();
    await slider.press("End");
  } else await enter(box, inWords(max * factor));
  await becomes(parameter.name, max);
  await expect.poll(() => box.inputValue(), kSoon).toBe(inWords(max * factor));
}

/** A list of the choices, by their titles; nothing else can be entered. */
async function checkChoices(parameter: ParameterJson): Promise<void> {
  const list = fieldOf(parameter).getByRole("combobox", { name: titleOf(parameter), exact: true });
  const { choices = [] } = parameter.meta;
  expect(await list.locator("option").allInnerTexts()).toEqual(choices.map(({ title }) => title));
  for (const { value, title } of choices) {
    await list.selectOption({ label: title });
    await becomes(parameter.name, value);
  }
}

/** A list of poses, and a box for the name of another one: of 1 to 32 characters. */
async function checkPose(parameter: ParameterJson): Promise<void> {
  const field = fieldOf(parameter);
  const list = field.getByRole("combobox", { name: titleOf(parameter), exact: true });
  expect((await onServer(parameter.name))?.value).toBeUndefined();
  await field.getByText(`"${titleOf(parameter)}" is not set`).waitFor();
  for (const name of ["P", "p".repeat(32)]) {
    await list.selectOption({ label: "Another…" });
    const box = field.getByRole("textbox", { name: `${titleOf(parameter)}: name of the pose` });
    await box.fill("no name");
    await field.getByText("A pose is called by 1 to 32 letters, digits, _ or -").waitFor();
    expect(await field.getByRole("button", { name: "Use it" }).isDisabled()).toBe(true);
    expect(await box.getAttribute("maxlength")).toBe("32");
    await box.fill(name);
    await field.getByRole("button", { name: "Use it" }).click();
    await becomes(parameter.name, name);
  }
  await list.selectOption({ label: "home" });
  await becomes(parameter.name, "home");
}

/** A box for a text of several lines; it takes no more than 2000 characters. */
async function checkText(parameter: ParameterJson): Promise<void> {
  const box = fieldOf(parameter).getByRole("textbox", { name: titleOf(parameter), exact: true });
  expect([await box.evaluate((each) => each.tagName), await box.getAttribute("maxlength")]).toEqual(["TEXTAREA", "2000"]);
  for (const text of ["x".repeat(2000), ""]) {
    await box.fill(text);
    await box.blur();
    await becomes(parameter.name, text);
  }
}

/** What the camera sees and knows, each to be switched on and off; others are typed. */
async function checkLabels(parameter: ParameterJson): Promise<void> {
  const group = fieldOf(parameter).getByRole("group", { name: titleOf(parameter), exact: true });
  await group.getByText("Seen now", { exact: true }).waitFor(); // what is seen has its place then
  const box = group.getByRole("checkbox", { name: "Cube", exact: true });
  const before = ((await onServer(parameter.name))?.value ?? []) as readonly string[];
  await expect.poll(() => group.getByRole("checkbox", { checked: true }).count(), kSoon).toBe(before.length);
  await box.setChecked(!before.includes("Cube"));
  await becomes(parameter.name, before.includes("Cube") ? before.filter((label) => label !== "Cube") : [...before, "Cube"]);
  const now = ((await onServer(parameter.name))?.value ?? []) as readonly string[];
  await group.getByRole("textbox").fill("Gear");
  await group.getByRole("button", { name: "Add" }).click();
  await becomes(parameter.name, [...now, "Gear"]);
}

async function checkYesNo(parameter: ParameterJson): Promise<void> {
  const box = fieldOf(parameter).getByRole("checkbox", { name: titleOf(parameter), exact: true });
  const before = (await onServer(parameter.name))?.value === true;
  for (const next of [!before, before]) {
    await box.setChecked(next);
    await becomes(parameter.name, next);
  }
}

/** Which of the steps before gives the part. */
async function checkFound(parameter: ParameterJson): Promise<void> {
  const list = fieldOf(parameter).getByRole("combobox", { name: titleOf(parameter), exact: true });
  expect(await list.locator("option").allInnerTexts()).toEqual(["What “Search a part” has found"]);
  expect((await onServer(parameter.name))?.from).toBe("chi.SearchObject.res.found");
}

/** By what its values mean, else by their type. */
function checkOf({ type, meta: { choices, domain } }: ParameterJson): (parameter: ParameterJson) => Promise<void> {
  if (domain === "found") return checkFound;
  if (choices !== undefined) return checkChoices;
  if (domain === "pose") return checkPose;
  if (domain === "labels") return checkLabels;
  if (domain === "text") return checkText;
  if (type === "bool") return checkYesNo;
  if (type === "int" || type === "number") return checkNumber;
  throw new Error(`nothing is known of a parameter of the type ${JSON.stringify(type)}`);
}

/** What can be pressed in the panel and is smaller than a finger needs. */
const small = (): Promise<readonly string[]> =>
  panel().evaluate((within, least) =>
    [...within.querySelectorAll<HTMLElement>("button, a, select, summary, textarea, input:not([type=checkbox], [type=radio]), label:has([type=checkbox], [type=radio])")]
      .filter((each) => each.checkVisibility())
      .map((each) => ({ text: each.outerHTML.slice(0, 90), box: each.getBoundingClientRect() }))
      .filter(({ box }) => box.width < least || box.height < least)
      .map(({ text, box }) => `${text}: ${Math.round(box.width)} x ${Math.round(box.height)}`),
  kTarget);

it("each skill of the demo's library is offered, once", async () => {
  expect(skillsOf(await documentOf("skills"))).toEqual(kSkills);
  expect(kSkills).toHaveLength(19);
  const own = await page.locator("[data-skill]").evaluateAll((cards) => cards.map((each) => each.getAttribute("data-skill") ?? ""));
  for (const { state } of kSkills) expect(own.filter((name) => name === state), state).toHaveLength(1);
});

describe.each(kSkills.map((skill) => [skill.meta.title ?? skill.state, skill] as const))("the form of “%s”", (title, skill) => {
  const parameters = skill.parameters ?? [];
  const shown = parameters.filter(({ meta }) => meta.internal !== true);

  it("says what the skill does, what each setting means, and what is to be done if it fails", async () => {
    await page.locator(`[data-skill="${skill.state}"]`).click();
    await expect.poll(() => panel().getByLabel("Name", { exact: true }).inputValue(), kSoon).toBe(title);
    await panel().getByText(skill.doc ?? "nothing", { exact: true }).waitFor();
    for (const summary of await panel().locator("summary").all()) await summary.click();
    await expect.poll(() => panel().locator("[aria-label=Settings] [data-parameter]").evaluateAll((fields) => fields.map((each) => each.getAttribute("data-parameter")).sort()), kSoon).toEqual(shown.map(({ name }) => name).sort());
    await expect.poll(() => panel().locator("details [data-parameter]").count(), kSoon).toBe(shown.filter(({ meta }) => meta.advanced === true).length);
    for (const parameter of shown) expect(await fieldOf(parameter).locator(".doc").first().innerText(), parameter.name).toBe(parameter.doc?.replaceAll("`", ""));
    const errors = (skill.ports ?? []).filter(({ meta }) => meta?.advice !== undefined);
    await expect.poll(() => panel().locator(".errors li").allInnerTexts(), kSoon).toEqual(errors.map(({ meta }) => `${meta?.title}. ${meta?.advice}`));
  });

  if (shown.length > 0)
    it(`has the control of its type for ${shown.map(({ name }) => name).join(", ")}: it takes both ends, and nothing beyond`, async () => {
      for (const parameter of shown) await checkOf(parameter)(parameter);
    });

  it("can be used by everybody, and with a finger", async () => {
    await fixture.screenshot(`skill-form-${skill.state}`);
    expect(await small()).toEqual([]);
    expect(await findings(page)).toEqual([]);
  });
});
