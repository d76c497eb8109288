// Tests of models in RACE-Pro: a run is made a test, which `race test` runs; what the tests come to is opened and marked in the drawing.
import { execFile } from "node:child_process";
import { copyFileSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { promisify } from "node:util";
import type { Page } from "playwright-core";
import { findings } from "./axe";
import { binary, demo, openFixture, settled, textOf, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

interface Places {
  readonly covered: number;
  readonly all: number;
  readonly missing: readonly string[];
}
interface ReportJson {
  readonly tests: readonly { readonly passed: boolean }[];
  readonly coverage: Readonly<Record<string, { readonly states: Places; readonly ports: Places }>>;
}

const execute = promisify(execFile);
let fixture: Fixture;
let page: Page;
/** The files of the demo, with the test that the page has made. */
let folder: string;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
  page.setDefaultTimeout(kPatience);
  await page.setViewportSize({ width: 1366, height: 768 });
  folder = mkdtempSync(join(tmpdir(), "race-model-tests-"));
  for (const name of readdirSync(demo)) if (!name.endsWith(".test.json")) copyFileSync(join(demo, name), join(folder, name));
});
afterAll(async () => {
  await fixture.close();
  rmSync(folder, { recursive: true, force: true });
});

const soon = (value: () => unknown) => expect.poll(value, kSoon);
const panel = () => page.getByRole("region", { name: "Coverage", exact: true });
const marks = (kind: string) => page.locator(`.coverage-mark.is-${kind}`).evaluateAll((all) => all.map((mark) => mark.getAttribute("data-coverage")).sort());
const open = (name: string, text: string) => panel().locator("input[type=file]").setInputFiles({ name, mimeType: "application/json", buffer: Buffer.from(text) });

/** Makes a run of a document, and waits for its end. */
async function runToEnd(document: string): Promise<string> {
  const { id } = (await fixture.send("POST", "/cores", { document })) as { readonly id: string };
  await fixture.send("POST", `/cores/${id}/start`);
  await expect.poll(async () => ((await fixture.send("GET", `/cores/${id}`)) as { readonly status: string }).status, { timeout: 90_000 }).toMatch(/ended|faulted/);
  return id;
}

/** That the pose of the part is not known: most states are never active. */
const kEarly = {
  race_test: 1,
  model: "pick.rcm.json",
  tests: [
    {
      name: "knows no pose",
      services: { gripper: { answers: [{ operation: "release", result: { actual_width: 0.11 } }] }, db: { answers: [{ operation: "get", error: { code: "unavailable" } }] } },
      expect: { outcome: "error" },
    },
  ],
};

/** What `race test --coverage --json` prints of a file in the folder, whose tests all pass. */
async function coverageOf(file: string): Promise<string> {
  const { stdout } = await execute(binary, ["test", file, "--coverage", "--json"], { cwd: folder, maxBuffer: 1 << 26 });
  expect((JSON.parse(stdout) as ReportJson).tests.map(({ passed }) => passed)).toEqual([true]);
  return stdout;
}

const ofPick = (report: string): { readonly states: Places; readonly ports: Places } => {
  const found = (JSON.parse(report) as ReportJson).coverage["pick.rcm.json"];
  if (found === undefined) throw new Error("there is no coverage of pick");
  return found;
};

/** The run of which a test is made, and the coverage of that. */
let run = "";
let made = "";

describe("a test of a run", () => {
  it("is saved from the end of the run, and passes", async () => {
    run = await runToEnd("pick");
    await page.goto(`${fixture.url}/pro/?run=${run}`);
    const card = page.getByRole("region", { name: "How it ended" });
    const make = card.getByRole("button", { name: "Make a test" });
    await make.focus();
    const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Enter")]);
    expect(download.suggestedFilename()).toBe("pick.test.json");
    const text = await textOf(download);
    await soon(() => card.getByRole("status").innerText()).toContain("Saved as pick.test.json");
    await fixture.screenshot("make-test");
    expect(await findings(page)).toEqual([]);
    expect(JSON.parse(text)).toMatchObject({ race_test: 1, tests: [{ name: `as run ${run}`, expect: { outcome: "success" } }] });
    writeFileSync(join(folder, "pick.test.json"), text);
    made = await coverageOf("pick.test.json");
  });

  it("is saved from the list of runs, which says why one makes none", async () => {
    const waiting = (await fixture.send("POST", "/cores", { document: "pick" })) as { readonly id: string };
    await page.getByRole("button", { name: "Runs", exact: true }).click();
    const row = (id: string) => page.getByRole("listitem", { name: `Run ${id}`, exact: true });
    fixture.allowError(/status of 422 .*\/runs\/\d+\/test/);
    await row(waiting.id).getByRole("button", { name: "Make a test" }).click();
    await soon(() => row(waiting.id).getByRole("alert").innerText()).toBe("No test is made: the run is not over");
    const [download] = await Promise.all([page.waitForEvent("download"), row(run).getByRole("button", { name: "Make a test" }).click()]);
    expect(download.suggestedFilename()).toBe("pick.test.json");
    await soon(() => row(run).getByRole("status").innerText()).toContain("race test pick.test.json");
    await fixture.screenshot("make-test-runs");
    expect(await findings(page)).toEqual([]);
    await page.keyboard.press("Escape");
  });
});

describe("coverage of tests", () => {
  let coverage = "";
  beforeAll(async () => {
    writeFileSync(join(folder, "early.test.json"), JSON.stringify(kEarly));
    coverage = await coverageOf("early.test.json");
  });
  const count = (name: string) => panel().locator(".coverage-counts div").filter({ hasText: name }).locator("dd").innerText();

  it("of the run that was made a test is opened by key: all its states were active", async () => {
    await page.goto(`${fixture.url}/pro/?edit=pick`);
    await settled(page);
    await page.keyboard.press("Control+Shift+Y");
    await panel().waitFor();
    await open("made.json", made);
    await soon(() => panel().getByRole("status").innerText()).toBe("made.json: 1 test, all passed");
    const { states } = ofPick(made);
    expect(states.missing).toEqual([]);
    expect(await count("States")).toBe(`${states.all} of ${states.all} (100 %)`);
    expect((await marks("never")).every((address) => address?.includes(".") === true)).toBe(true);
    await fixture.screenshot("coverage-made");
  });

  it("is marked in the drawing and listed", async () => {
    await open("coverage.json", coverage);
    await soon(() => panel().getByRole("status").innerText()).toBe("coverage.json: 1 test, all passed");
    const { states, ports } = ofPick(coverage);
    expect(states.missing).toContain("Pick/Grasp");
    expect(await count("States")).toMatch(new RegExp(`^${states.covered} of ${states.all} \\(`));
    expect(await count("Ports")).toMatch(new RegExp(`^${ports.covered} of ${ports.all} \\(`));
    expect(await panel().getByRole("note").count()).toBe(0);
    // Of what is drawn closed, what is in it has no sign of its own.
    const drawn = new Set(await page.locator("#edit-canvas [data-path]").evaluateAll((all) => all.map((each) => each.getAttribute("data-path"))));
    const inDrawing = (place: string) => drawn.has(place.split(".")[0] ?? "");
    await soon(() => marks("never")).toEqual([...states.missing, ...ports.missing].filter(inDrawing).sort());
    expect(await marks("never")).toContain("Pick/Grasp");
    expect((await marks("partly")).length).toBeGreaterThan(0);
    await fixture.screenshot("coverage");
    expect(await findings(page)).toEqual([]);
    await page.emulateMedia({ colorScheme: "dark" });
    await soon(() => findings(page)).toEqual([]);
    await fixture.screenshot("coverage-dark");
    await page.emulateMedia({ colorScheme: "light" });
  });

  it("leads from each row to its state or port by keyboard", async () => {
    const row = panel().getByRole("list", { name: "Never fired" }).getByRole("button").first();
    const address = await row.innerText();
    await row.focus();
    await page.keyboard.press("Enter");
    await soon(() => new URL(page.url()).searchParams.get("sel")).toBe(address);
  });

  it("of another revision or document says so", async () => {
    const report = JSON.parse(coverage) as ReportJson;
    const model = ofPick(coverage);
    const older = { ...report, coverage: { "pick.rcm.json": { ...model, states: { ...model.states, missing: [...model.states.missing, "Pick/Gone"] } } } };
    await open("older.json", JSON.stringify(older));
    await soon(() => panel().getByRole("note").innerText()).toMatch(/another revision: it has 1 state or port that the document does not have \(Pick\/Gone\)/);
    await soon(() => panel().getByRole("list", { name: "Never active" }).innerText()).toContain("Pick/Gone (not in this document)");
    await fixture.screenshot("coverage-older");
    await open("other.json", JSON.stringify({ ...report, coverage: { "place.rcm.json": model } }));
    await soon(() => panel().getByRole("note").innerText()).toBe("It is of place.rcm.json, not of pick.");
  });

  it("refuses what is no coverage, and keeps what was open", async () => {
    await open("coverage.json", coverage);
    await soon(() => panel().getByRole("note").count()).toBe(0);
    await open("pick.rcm.json", JSON.stringify({ rcm: 1, root: {} }));
    await soon(() => panel().getByRole("alert").innerText()).toContain("pick.rcm.json is no coverage: /tests: expected a value");
    await soon(() => panel().getByRole("status").innerText()).toContain("coverage.json");
    expect(await findings(page)).toEqual([]);
  });

  it("is closed by key, with its marks", async () => {
    await panel().getByRole("heading", { name: "Coverage" }).focus();
    await page.keyboard.press("Escape");
    await soon(() => panel().count()).toBe(0);
    expect(await marks("never")).toEqual([]);
    await page.getByRole("button", { name: "Coverage" }).click();
    await soon(() => panel().innerText()).toContain("race test --coverage --json");
    expect(await marks("never")).toEqual([]);
  });

  it("opens when it is dropped on any page, on the document of its name", async () => {
    await page.goto(`${fixture.url}/pro/`);
    await page.getByRole("button", { name: "Documents", exact: true }).waitFor();
    await soon(() => page.getByRole("combobox", { name: "Document", exact: true }).locator("option").count()).toBeGreaterThan(0);
    const data = await page.evaluateHandle((text) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([text], "coverage.json", { type: "application/json" }));
      return transfer;
    }, coverage);
    await page.dispatchEvent("body", "drop", { dataTransfer: data });
    await soon(() => panel().getByRole("status").innerText()).toBe("coverage.json: 1 test, all passed");
    await soon(() => new URL(page.url()).searchParams.get("edit")).toBe("pick");
    await soon(async () => (await marks("never")).length).toBeGreaterThan(0);
  });
});
