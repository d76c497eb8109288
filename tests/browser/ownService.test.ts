// A service of one's own, in Python: offered by both pages as soon as it is connected, added by keys, run, lost, and offered anew with another operation.
import { spawn, type ChildProcess } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Locator, Page } from "playwright-core";
import type { HostedService } from "../../web/generated/messages";
import { documentOf } from "../../web/shared/edit/tree";
import { skillsOfService } from "../../web/shared/skills/serviceSkills";
import { findings } from "./axe";
import { openFixture, project, settled, type Fixture } from "./fixture";
import { kSoon } from "./patience";

const kKey = "my_gripper";
/** What a page may take to show a service that the server has [ms]. */
const kAtOnce = { timeout: 2000 };
const kProgram = readFileSync(join(project, "api/templates/gripper_python/gripper.py"), "utf8");
/** With one operation more. */
const kAnother = kProgram.replace("\n\nGripper().run()", '\n    @operation(reads=True, result="number")\n    def stroke(self):\n        return STROKE\n\n\nGripper().run()');

interface StateJson {
  readonly state: string;
  readonly link?: string;
  readonly children?: readonly StateJson[];
  readonly parameters?: readonly { readonly name: string; readonly value?: unknown }[];
}
interface Entry {
  readonly revision: number;
  readonly errors: readonly unknown[];
  readonly document: { readonly services?: unknown; readonly root: StateJson; readonly library?: readonly StateJson[] };
}

const folder = mkdtempSync(join(tmpdir(), "race-own-"));
let fixture: Fixture;
let pro: Page;
let one: Page;
let program: ChildProcess | undefined;

/** Its answer is what Get gives: a draft as long as that is not there. */
const kTask = {
  rcm: 1,
  root: {
    state: "Root", results: [{ name: "width" }],
    actions: [{ when: "available(chi.MyGripperGet.res.width)", do: "res.width = chi.MyGripperGet.res.width" }],
    ports: [{ name: "done", when: "chi.MyGripperGet.port.done and available(res.width)" }],
  },
};

beforeAll(async () => {
  fixture = await openFixture();
  await fixture.send("PUT", "/documents/grip?draft=true", kTask);
  await fixture.send("PUT", "/documents/tasks", { rcm: 1, name: "tasks", root: { state: "Application", meta: { id: "root" } } });
  pro = fixture.page;
  one = await (await fixture.openContext({ viewport: { width: 1366, height: 900 }, reducedMotion: "reduce" })).newPage();
  for (const page of [pro, one]) page.setDefaultTimeout(kSoon.timeout);
  await pro.goto(`${fixture.url}/pro/?edit=grip`);
  await settled(pro);
  await one.goto(`${fixture.url}/one/?edit=tasks`);
  await one.getByLabel("Name of the task").fill("Look");
  await one.getByRole("button", { name: "Add the task" }).click();
  await one.locator("[data-skill]").first().waitFor();
});
afterAll(async () => {
  await end();
  await fixture.close();
  rmSync(folder, { recursive: true, force: true });
});

const services = async (): Promise<readonly HostedService[]> => ((await fixture.send("GET", "/services")) as { readonly services: readonly HostedService[] }).services;
const operations = async (): Promise<readonly string[] | undefined> => (await services()).find(({ key, available }) => key === kKey && available)?.rsm.operations.map(({ name }) => name);
const stored = async (name: string): Promise<Entry> => (await fixture.send("GET", `/documents/${name}`)) as Entry;

/** Starts the program; returns when the server has what it offers. */
async function begin(text: string, operation: string): Promise<void> {
  const file = join(folder, "gripper.py");
  writeFileSync(file, text);
  program = spawn("/usr/bin/python3", ["-B", file, "--server", fixture.url, "--token-file", join(fixture.data, "processes.token")], {
    stdio: ["ignore", "ignore", "inherit"], env: { PYTHONPATH: join(project, "api/python"), PATH: "/usr/bin:/bin" },
  });
  await expect.poll(operations, { interval: 20, ...kSoon }).toContain(operation);
}

async function end(): Promise<void> {
  const ended = new Promise((resolve) => program?.once("exit", resolve));
  if (program?.kill("SIGKILL") === true) await ended;
  program = undefined;
}

/** Makes a run of a document, and waits for its end. */
async function run(name: string): Promise<{ readonly status: string; readonly outcome?: string; readonly results?: unknown }> {
  const { id } = (await fixture.send("POST", "/cores", { document: name })) as { readonly id: string };
  await fixture.send("POST", `/cores/${id}/start`);
  const core = async () => (await fixture.send("GET", `/cores/${id}`)) as { readonly status: string };
  await expect.poll(async () => (await core()).status, kSoon).not.toBe("running");
  return core();
}

const inPro = (): Locator => pro.locator(`[data-service="${kKey}"]`);
const operation = (name: string): Locator => inPro().locator(`[data-operation="${kKey}.${name}"]`);
const inOne = (): Locator => one.getByRole("region", { name: `Service ${kKey}` });
const skill = (title: string): Locator => inOne().locator("[data-skill]", { hasText: title });
const steps = (): Promise<readonly string[]> => one.getByRole("region", { name: "Task Look" }).locator(".step > .card strong").allInnerTexts();
const saved = () => one.getByRole("status", { name: "Connection" }).filter({ hasText: "Saved" }).waitFor();

it("is nowhere before it is connected, and a person is told how that is done", async () => {
  expect([await inPro().count(), await inOne().count()]).toEqual([0, 0]);
  await pro.getByText("Connect one of your own").click();
  await pro.getByText(`gripper.py --server ${fixture.url}`).waitFor();
  await pro.getByText("Connect one of your own").click();
});

it("appears on both pages when it is connected", async () => {
  await begin(kProgram, "move");
  await Promise.all([inPro().waitFor(kAtOnce), inOne().waitFor(kAtOnce)]);
  expect(await findings(one)).toEqual([]);
});

it("is added in RACE-Pro by keys, with its service, as one edit", async () => {
  await inPro().locator("summary").focus();
  await pro.keyboard.press("Enter");
  await operation("get").waitFor();
  expect(await inPro().locator("[data-operation]").evaluateAll((all) => all.map((each) => each.getAttribute("data-operation")))).toEqual([`${kKey}.move`, `${kKey}.get`]);
  for (const name of ["move", "get"]) {
    await pro.keyboard.press("Tab");
    await expect.poll(() => operation(name).evaluate((each) => each === document.activeElement)).toBe(true);
  }
  const { revision, errors } = await stored("grip");
  expect(errors).not.toEqual([]);
  await pro.keyboard.press("Enter");
  await expect.poll(async () => (await stored("grip")).revision).toBe(revision + 1);
  const added = await stored("grip");
  expect(added.errors).toEqual([]);
  expect(added.document).toMatchObject({ services: { [kKey]: kKey }, root: { first: "MyGripperGet", children: [{ state: "MyGripperGet", entry: "svc.my_gripper.get()" }] } });
  expect(await findings(pro)).toEqual([]);
  await fixture.screenshot("own-service-pro", pro);
  await pro.getByRole("button", { name: "Undo", exact: true }).click();
  await expect.poll(async () => (await stored("grip")).document.root.children).toBeUndefined();
  expect((await stored("grip")).document.services).toBeUndefined();
  await pro.getByRole("button", { name: "Redo", exact: true }).click();
  await expect.poll(async () => (await stored("grip")).document.root.children?.length).toBe(1);
});

it("is run, to the end with its result", async () => {
  expect(await run("grip")).toMatchObject({ status: "ended", outcome: "done", results: { width: 0.11 } });
});

it("is added in RACE-One by keys, and run with the value that is typed", async () => {
  await inOne().locator("summary").focus();
  await one.keyboard.press("Enter");
  await skill("Move (my_gripper)").focus();
  await one.keyboard.press("Enter");
  await expect.poll(steps).toEqual(["Move (my_gripper)"]);
  await saved();
  const width = one.getByRole("complementary", { name: "What is selected" }).getByRole("textbox", { name: "Width", exact: true });
  await width.fill("10");
  await width.press("Enter");
  await expect.poll(async () => (await stored("tasks")).document.root.children?.[0]?.children?.[0]?.parameters?.[0]?.value).toBe(0.1);
  // What is made of it does not count as a skill that somebody has written.
  await skill("Get (my_gripper)").focus();
  await one.keyboard.press("Enter");
  await expect.poll(steps).toEqual(["Move (my_gripper)", "Get (my_gripper)"]);
  expect(await one.locator("[data-skill]", { hasText: "(my_gripper)" }).count()).toBe(2);
  await saved();
  const { document, errors } = await stored("tasks");
  expect([errors, document.services, document.library?.map(({ state }) => state)]).toEqual([[], { [kKey]: kKey }, ["MyGripperMove", "MyGripperGet"]]);
  await fixture.screenshot("own-service-one", one);
  expect(await run("tasks")).toMatchObject({ status: "ended", outcome: "success" });
  expect(await run("grip")).toMatchObject({ results: { width: 0.1 } });
});

it("is shown as not there when its process is lost, and its error ends the task", async () => {
  await end();
  await inPro().getByText("not there now").waitFor(kAtOnce);
  await inOne().getByText("Not here: the service my_gripper").first().waitFor(kAtOnce);
  expect(await skill("Get (my_gripper)").getAttribute("aria-disabled")).toBe("true");
  await fixture.screenshot("own-service-away", one);
  expect(await run("tasks")).toMatchObject({ status: "ended", outcome: "error" });
});

it("comes back with another operation, which is offered where the groups are open", async () => {
  await begin(kAnother, "stroke");
  await Promise.all([operation("stroke").waitFor(kAtOnce), skill("Stroke (my_gripper)").waitFor(kAtOnce)]);
  expect(await inOne().getByText(/^Not here/).count()).toBe(0);
  await operation("stroke").focus();
  await pro.keyboard.press("Enter");
  await expect.poll(async () => (await stored("grip")).document.root.children?.map(({ state }) => state)).toContain("MyGripperStroke");
});

it("is not offered in RACE-One any more when somebody has written a skill for it", async () => {
  const written = { state: "OpenWide", entry: "svc.my_gripper.move(0.11)", ports: [{ name: "success", when: "svc.my_gripper.move.result" }], meta: { skill: true, title: "Open wide" } };
  await fixture.send("PUT", "/documents/my-skills", { rcm: 1, services: { [kKey]: kKey }, library: [written], root: { state: "Root" } });
  // Which documents there are, a page asks when it is connected.
  await one.reload();
  await one.locator("[data-skill=OpenWide]").waitFor();
  expect(await inOne().count()).toBe(0);
  expect(await operation("move").count()).toBe(1);
});

it("of every service of the cell, what is offered passes the check of the server", async () => {
  const all = await services();
  for (const service of all) {
    const made = skillsOfService(service);
    expect(made, service.key).toBeDefined();
    if (made === undefined) continue;
    const { errors } = (await fixture.send("PUT", "/documents/made?draft=true", documentOf(made.document.tree))) as Entry;
    expect(errors, service.key).toEqual([]);
  }
  expect(all.length).toBeGreaterThan(6);
});
