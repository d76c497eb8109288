// Breakpoints, steps and forcing on the expert page, on the real server with the demo task Pick, and with tasks that do nothing by themselves.
import { findings } from "./axe";
import { editPage } from "./editPage";
import { openFixture, settled, type Fixture } from "./fixture";
import { letMove } from "./hands";
import { kPatience, kSoon } from "./patience";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
  fixture.page.setDefaultTimeout(kPatience);
  await fixture.page.setViewportSize({ width: 1366, height: 768 });
  // Of a condition that is wrong.
  fixture.allowError(/ 422 .*\/breakpoints/);
});
afterAll(() => fixture.close());

const soon = (value: () => unknown) => expect.poll(value, kSoon);

interface CoreJson {
  readonly id: string;
  readonly status: string;
  readonly paused: boolean;
  readonly step: number;
  readonly micro: number;
  readonly breakpoints: readonly Readonly<Record<string, unknown>>[];
  readonly reached?: readonly number[];
}
const core = async (id: string) => (await fixture.send("GET", `/cores/${id}`)) as CoreJson;
const stateOf = async (id: string) =>
  ((await fixture.send("GET", `/cores/${id}/state`)) as { readonly state: { readonly active: readonly string[]; readonly parameters: Readonly<Record<string, Readonly<Record<string, unknown>>>> } }).state;
const watched = () => fixture.page.getByRole("combobox", { name: "Watched run" }).inputValue();
const button = (name: string) => fixture.page.getByRole("toolbar", { name: "Run" }).getByRole("button", { name, exact: true });
const panel = () => fixture.page.getByRole("region", { name: "Breakpoints" });
const rows = () => panel().getByRole("listitem");
const reached = () => fixture.page.getByRole("status", { name: "Breakpoint" });
const dot = (address: string) => fixture.page.locator(`[data-breakpoint="${address}"]`);
const choose = (name: string | RegExp) => fixture.page.getByRole("menuitem", { name }).click();
const press = (key: string) => fixture.page.keyboard.press(key);
const isActive = (path: string) => fixture.page.getByRole("treeitem", { name: path, exact: true }).getAttribute("data-active");

const kPort = "Pick/GetPose.success";
/** As cores have it, of who has chosen no name. */
const ofGuest = { when: "tested", id: "22al3uy5", author: expect.stringMatching(/^Guest \d+$/) as unknown };

describe("a breakpoint", () => {
  it("on a tested port, set in the drawing before the run, stops the run", async () => {
    const { page } = fixture;
    await page.goto(`${fixture.url}/pro/?edit=pick`);
    await letMove(page, "pick");
    await settled(page);
    await soon(() => panel().innerText()).toContain("Ctrl+B");
    await editPage(fixture).port(kPort).click({ button: "right" });
    await choose(/^Breakpoint when/);
    await choose("the condition of the port is evaluated");
    await soon(() => rows().count()).toBe(1);
    const condition = rows().getByRole("textbox", { name: "Condition" });
    await condition.fill("par.kee == 1");
    await soon(() => rows().innerText()).toContain("kee is not declared here");
    await condition.press("Escape");
    await soon(() => dot(kPort).getAttribute("aria-label")).toBe("Breakpoint: GetPose.success, tested");
    await soon(() => page.getByRole("treeitem", { name: "Pick/GetPose" }).getByRole("img", { name: /^Breakpoint: / }).count()).toBe(1);
    await press("F5");
    await soon(watched).not.toBe("");
    const id = await watched();
    await soon(async () => (await core(id)).breakpoints).toEqual([ofGuest]);
    await button("Start").click();
    await soon(() => reached().innerText()).toContain("Paused: breakpoint at GetPose.success, tested");
    expect(await reached().innerText()).toContain("open calls go on, and their time-outs run");
    const now = await core(id);
    expect([now.paused, now.reached]).toEqual([true, [0]]);
    expect((await stateOf(id)).active).toContain("Pick/GetPose");
    await reached().getByRole("button", { name: "GetPose.success, tested" }).click();
    await soon(() => page.getByRole("complementary", { name: "Properties" }).getByRole("heading", { level: 2 }).innerText()).toBe("success");
    await soon(() => page.getByRole("group", { name: "Breakpoints here" }).getByRole("button", { pressed: true }).allInnerTexts()).toEqual(["tested"]);
    await fixture.screenshot("debugger-reached");
    await page.emulateMedia({ colorScheme: "dark" });
    await fixture.screenshot("debugger-reached-dark");
    // What has just fired flashes.
    await soon(() => page.evaluate(() => document.getAnimations().length)).toBe(0);
    expect(await findings(page)).toEqual([]);
    await page.emulateMedia({ colorScheme: "light" });
  });

  it("whose condition is wrong says so in its row, and not in a dialog; what others have set stays", async () => {
    const id = await watched();
    const others = { when: "entered", path: "Pick/Retreat", author: "Ann" };
    await fixture.send("PUT", `/cores/${id}/breakpoints?author=Ann`, { breakpoints: [{ when: "entered", path: "Pick/Retreat" }] });
    expect((await core(id)).breakpoints).toEqual([ofGuest, others]);
    const condition = rows().getByRole("textbox", { name: "Condition" });
    await condition.fill("parr.key == 1");
    await soon(() => rows().innerText()).toContain("parr is not known here");
    await soon(() => condition.getAttribute("aria-invalid")).toBe("true");
    await condition.press("Escape");
    await soon(() => rows().innerText()).not.toContain("parr");
    await condition.fill("par.");
    await condition.press("Enter");
    await soon(() => rows().innerText()).toMatch(/Not in the run: condition: /);
    expect(await fixture.page.getByRole("alert").count()).toBe(0);
    await soon(async () => (await core(id)).breakpoints).toEqual([others]);
    await fixture.screenshot("debugger-condition");
    await condition.fill("available(par.key)");
    await condition.press("Enter");
    await soon(async () => (await core(id)).breakpoints).toEqual([others, { ...ofGuest, condition: "available(par.key)" }]);
    await soon(() => rows().innerText()).not.toContain("Not in the run");
    await rows().getByRole("button", { name: /^Enabled/ }).click();
    await soon(async () => (await core(id)).breakpoints).toEqual([others]);
    await soon(() => dot(kPort).getAttribute("class")).toContain("is-off");
    await rows().getByRole("button", { name: /^Enabled/ }).click();
    await soon(async () => (await core(id)).breakpoints.length).toBe(2);
  });

  it("is kept over a reload and a restart of the server, and a run that goes on gets it again", async () => {
    const { page } = fixture;
    const id = await watched();
    await page.reload();
    await soon(() => rows().count()).toBe(1);
    await fixture.kill();
    await fixture.restart();
    await page.reload();
    await settled(page);
    await soon(() => rows().getByRole("textbox", { name: "Condition" }).inputValue()).toBe("available(par.key)");
    await soon(async () => (await core(id)).status).toBe("interrupted");
    expect((await core(id)).breakpoints).toEqual([]);
    await button("Resume").click();
    await soon(async () => (await core(id)).breakpoints.map(({ when }) => when)).toEqual(["tested"]);
    // The task ends, as the call that was open is answered `unavailable`; or the pose had come before, and the port is tested.
    const goesOn = async () => {
      const { status, paused } = await core(id);
      return status === "running" && paused ? "paused" : status;
    };
    await soon(goesOn).toMatch(/^(paused|ended)$/);
    if ((await goesOn()) === "paused") {
      await soon(() => page.getByRole("status", { name: "Run status" }).innerText()).toContain("Paused");
      await press("F8");
    }
    await soon(goesOn).toMatch(/^(aborted|ended)$/);
  });

  it("on the call of an operation stops before the call", async () => {
    const { page } = fixture;
    await rows().getByRole("button", { name: /^Remove/ }).click();
    await panel().getByRole("button", { name: "Add a breakpoint" }).click();
    await choose("Breakpoint at any call");
    await rows().getByRole("button", { name: /make it before/ }).click();
    await rows().getByRole("combobox", { name: "Operation" }).selectOption({ label: "robot.move" });
    await soon(() => rows().getAttribute("aria-label")).toBe("the whole task, before: calls robot.move");
    const before = await watched();
    await button("Run again").click();
    await soon(watched).not.toBe(before);
    await soon(() => reached().innerText()).toContain("before: calls robot.move");
    const { services } = (await fixture.send("GET", "/services")) as { readonly services: readonly { readonly key: string; readonly pending_count: number }[] };
    expect(services.find(({ key }) => key === "robot")?.pending_count).toBe(0);
    await fixture.screenshot("debugger-called");
    await rows().getByRole("button", { name: /^Remove/ }).click();
    await press("F8");
    await page.locator(".run-status.is-aborted").waitFor();
  });
});

const never = { name: "never", when: "False" };
/** In one macro step it goes from A1 over A2 to B, where it stays. */
const steps = {
  rcm: 1,
  root: {
    state: "Root", first: "A", ports: [never],
    children: [
      { state: "A", first: "A1", ports: [{ name: "done", when: "chi.A2.port.done", to: "B" }], children: [{ state: "A1", ports: [{ name: "done", when: "True", to: "A2" }] }, { state: "A2", ports: [{ name: "done", when: "True" }] }] },
      { state: "B", parameters: [{ name: "speed", value: 0.3 }], ports: [{ name: "next", when: "False", to: "C" }] },
      { state: "C", ports: [never] },
    ],
  },
};

describe("a paused run", () => {
  let id: string;
  beforeAll(async () => {
    await fixture.send("PUT", "/documents/steps", steps);
    id = ((await fixture.send("POST", "/cores", { document: "steps", arguments: {} })) as CoreJson).id;
    await fixture.page.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(fixture.page);
  });

  it("steps over the active state, and out of the one around it, by keys", async () => {
    await press("F6");
    await soon(async () => (await core(id)).paused).toBe(true);
    const place = async () => {
      const { step, micro } = await core(id);
      return `${step} ${micro}`;
    };
    const inA1 = async () => (await stateOf(id)).active.includes("Root/A/A1");
    for (let i = 0; i < 4 && !(await inA1()); ++i) {
      const before = await place();
      await press("F4");
      await soon(place).not.toBe(before);
    }
    await soon(() => isActive("Root/A/A1")).toBe("true");
    await press("F10");
    await soon(() => isActive("Root/A/A1")).toBe("false");
    expect(await isActive("Root/A/A2")).toBe("false");
    await press("F10");
    await soon(() => isActive("Root/A/A2")).toBe("true");
    await press("Shift+F11");
    await soon(() => isActive("Root/A")).toBe("false");
    await press("F10");
    await soon(() => isActive("Root/B")).toBe("true");
  });

  it("leaves a state through a port that is forced, once that is confirmed, and the history says so", async () => {
    const { page } = fixture;
    await press("Shift+F4");
    await soon(async () => (await core(id)).status).toBe("running");
    await page.locator('.canvas [data-path="Root/B"]').first().click({ button: "right", position: { x: 20, y: 8 } });
    await fixture.screenshot("debugger-menu");
    await choose(/^Leave through port/);
    await choose("next → C");
    const bar = page.getByRole("form", { name: "Force" });
    expect(await bar.innerText()).toMatch(/Leave B through next\?[^]*recorded in the journal[^]*robot may move/);
    expect((await stateOf(id)).active).toContain("Root/B");
    await fixture.screenshot("debugger-force");
    await page.keyboard.press("Enter");
    await soon(async () => (await stateOf(id)).active).toContain("Root/C");
    await bar.waitFor({ state: "detached" });
    await page.getByRole("tab", { name: "Derivation" }).click();
    await soon(() => page.getByRole("list", { name: "Macro steps" }).innerText()).toContain("force Root/B.next");
  });

  it("takes a value that is forced", async () => {
    const { page } = fixture;
    await fixture.page.getByRole("treeitem", { name: "Root/B", exact: true }).getByRole("button").last().click();
    const parameters = page.getByRole("region", { name: "Parameters" });
    await parameters.getByRole("button", { name: "Force speed" }).click();
    const bar = page.getByRole("form", { name: "Force" });
    const field = bar.getByRole("textbox", { name: "Value of speed" });
    await field.fill("0.1 +");
    await field.press("Enter");
    await soon(() => bar.getByRole("alert").innerText()).toContain("This is no value");
    await field.fill("0.1");
    await field.press("Enter");
    await soon(async () => (await stateOf(id)).parameters["Root/B"]?.["speed"]).toBe(0.1);
    await soon(() => parameters.innerText()).toContain("0.1");
  });

  it("runs until what is selected is reached, and has breakpoints by key", async () => {
    const { page } = fixture;
    await page.getByRole("treeitem", { name: "Root/A/A2", exact: true }).getByRole("button").last().click();
    await press("Control+b");
    await soon(() => rows().count()).toBe(1);
    await soon(async () => (await core(id)).breakpoints.map(({ when }) => when)).toEqual(["entered"]);
    await press("Control+b");
    await soon(async () => (await core(id)).breakpoints).toEqual([]);
    await button("Stop").click();
    await page.locator(".run-status.is-aborted").waitFor();
    await button("Run again").click();
    await soon(watched).not.toBe(id);
  });
});
