// The form for the arguments of a run, on the real server: what is typed is what the run has, to the digit.
import type { Page } from "playwright-core";
import { openFixture, type Fixture } from "./fixture";

let fixture: Fixture;

const kPose = '{"position": [0.0, 1, 2.50], "orientation": [0, 0, 0, 1.0]}';
/** One parameter of each kind. The text is sent as it is: 1.0 is a float. */
const kKinds = `{"rcm": 1, "root": {"state": "Root", "doc": "Takes everything.", "parameters": [
  {"name": "count", "type": "int", "value": 3, "doc": "How often"},
  {"name": "speed", "type": "number", "value": 1.0, "unit": "m/s", "doc": "Of the tool", "meta": {"min": 0, "max": 2}},
  {"name": "force", "type": "number", "value": 2, "unit": "N"},
  {"name": "label", "type": "string", "value": "part"},
  {"name": "careful", "type": "bool", "value": true},
  {"name": "side", "type": {"enum": ["left", "right", 1.0]}, "value": "left"},
  {"name": "pose", "type": "pose"},
  {"name": "points", "type": {"list": "number"}, "value": [1.0, 2]},
  {"name": "limits", "type": {"record": {"low": "number", "high": {"optional": "number"}}}, "value": {"low": 0}},
  {"name": "grip", "type": {"optional": "number"}, "value": null},
  {"name": "other", "value": 1.0}
], "ports": [{"name": "done", "when": "False"}]}}`;
const kPlain = '{"rcm": 1, "root": {"state": "Plain", "ports": [{"name": "done", "when": "False"}]}}';

const put = async (name: string, text: string) => {
  const answer = await fetch(`${fixture.url}/api/v1/documents/${name}`, { method: "PUT", body: text, headers: { "content-type": "application/json" } });
  expect(answer.ok).toBe(true);
};
const form = (page: Page) => page.getByRole("dialog", { name: /^Arguments of/ });
const field = (page: Page, name: string) => form(page).getByLabel(name, { exact: false }).and(page.locator(`[name="${name}"]`));
const hasFocus = (page: Page, name: string) => expect.poll(() => field(page, name).evaluate((input) => input === document.activeElement)).toBe(true);
const ids = async (): Promise<readonly string[]> => ((await fixture.send("GET", "/cores")) as { cores: { id: string }[] }).cores.map(({ id }) => id);
/** A run as the server writes it, without spaces. */
const textOf = async (id: string): Promise<string> => (await (await fetch(`${fixture.url}/api/v1/cores/${id}`)).text()).replace(/\s/g, "");
/** Does something that makes a run; its id. */
async function made(action: () => Promise<void>): Promise<string> {
  const before = await ids();
  await action();
  await expect.poll(async () => (await ids()).length).toBe(before.length + 1);
  return (await ids()).find((id) => !before.includes(id)) ?? "";
}
const choose = (page: Page, name: string) => page.getByRole("combobox", { name: "Document" }).selectOption(name);

beforeAll(async () => {
  fixture = await openFixture();
  const { page } = fixture;
  await put("kinds", kKinds);
  await put("plain", kPlain);
  await page.goto(`${fixture.url}/pro/`);
  await page.getByRole("combobox", { name: "Document" }).getByRole("option", { name: "plain" }).waitFor({ state: "attached" });
});
afterAll(() => fixture.close());

it("does not ask for arguments if the root has no parameters", async () => {
  const { page } = fixture;
  await choose(page, "plain");
  const id = await made(() => page.getByRole("button", { name: "Load", exact: true }).click());
  expect(await textOf(id)).toContain('"arguments":{}');
  expect(await page.getByRole("button", { name: "Arguments…" }).count()).toBe(0);
});

it("makes a run at once if all parameters have values, and offers the form", async () => {
  const { page } = fixture;
  await choose(page, "pick");
  await page.getByRole("button", { name: "Arguments…" }).waitFor();
  const id = await made(() => page.getByRole("button", { name: "Load", exact: true }).click());
  expect(await textOf(id)).toContain('"arguments":{}');
});

it("asks if one has no value, tells what each field expects, and what is wrong", async () => {
  const { page, screenshot } = fixture;
  await choose(page, "kinds");
  await page.getByRole("button", { name: "Load", exact: true }).click();
  await form(page).waitFor();
  await screenshot("arguments");
  await expect.poll(() => field(page, "speed").inputValue()).toBe("1.0");
  expect(await field(page, "speed").evaluate((input) => document.getElementById(input.getAttribute("aria-describedby") ?? "")?.textContent)).toBe("Of the tool a number, in m/s, 0 to 2");
  const before = (await ids()).length;
  await field(page, "count").fill("1.0");
  await field(page, "speed").fill("2.5");
  await form(page).getByRole("button", { name: "Load", exact: true }).click();
  const wrong = form(page).locator(".argument-problem");
  await expect.poll(() => wrong.allTextContents()).toEqual(["count must be a whole number", "speed must be at most 2", "pose needs a value"]);
  await hasFocus(page, "count");
  await screenshot("arguments-wrong");
  expect((await ids()).length).toBe(before);
  await page.keyboard.press("Escape");
  await expect.poll(() => form(page).count()).toBe(0);
});

it("sends what is typed by the keyboard alone, to the digit, and nothing that was not changed", async () => {
  const { page } = fixture;
  await page.getByRole("button", { name: "Arguments…" }).focus();
  await page.keyboard.press("Enter");
  await form(page).waitFor();
  await hasFocus(page, "count");
  const next = async (text: string) => {
    await page.keyboard.press("Control+A");
    await page.keyboard.type(text);
    await page.keyboard.press("Tab");
  };
  await next("7");
  await next("2.0");
  await page.keyboard.press("Tab");
  await next("1.0");
  await page.keyboard.press("f");
  await page.keyboard.press("Tab");
  await page.keyboard.press("1");
  await page.keyboard.press("Tab");
  await next(kPose);
  await next("[3.0, 4]");
  await next('{"low": 1.0, "high": null}');
  await next("0.50");
  await next('{"a": [9007199254740993, 1000.0]}');
  // Behind the fields: Cancel, Load, Load and start.
  await page.keyboard.press("Tab");
  const id = await made(() => page.keyboard.press("Enter"));
  await expect.poll(() => form(page).count()).toBe(0);
  const text = await textOf(id);
  const sent: Readonly<Record<string, string>> = {
    count: "7", speed: "2.0", label: '"1.0"', careful: "false", side: "1.0", pose: '{"position":[0.0,1,2.5],"orientation":[0,0,0,1.0]}', points: "[3.0,4]", limits: '{"low":1.0,"high":null}', grip: "0.5", other: '{"a":[9007199254740993,1000.0]}',
  };
  for (const [name, value] of Object.entries(sent)) expect(text, name).toContain(`"${name}":${value}`);
  expect(text).not.toContain("force");

  // Once more, with the same arguments.
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await page.getByRole("button", { name: "Stop", exact: true }).click();
  await page.getByRole("button", { name: "Run again" }).waitFor();
  const again = await made(() => page.getByRole("button", { name: "Run again" }).click());
  const twice = await textOf(again);
  for (const [name, value] of Object.entries(sent)) expect(twice, name).toContain(`"${name}":${value}`);
});
