// ObjectRecognition (thesis, Fig. 5.1 and A.2) is built from an empty document, one half by mouse and the other by keyboard alone; it runs in the
// cell as the demonstrator's does, and all of it is undone and redone. REST only reads what came of it, and makes the run it is compared with.
// What Fig. A.2 calls StorePose is SaveObjectPose in Fig. 5.1 and here. Around it is a task of this test: a barrier begins it beside a time-out.
import { cpSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { isExactObject, itemsOf, type ExactObject } from "../../web/shared/edit/clipboard/json";
import { readExact, writeExact, type ExactJson } from "../../web/shared/edit/exact";
import { offered } from "./editPage";
import { demo, openFixture, settled, type Fixture } from "./fixture";
import { heard, keyboard, mouse } from "./hands";
import { kPatience } from "./patience";

const kName = "search";
const known = readExact(readFileSync(join(demo, "demonstrator.rcm.json"), "utf8")) as ExactObject;

/** Without what the editor adds for itself: ids and places; entries in one order. */
function meaning(json: ExactJson): ExactJson {
  if (Array.isArray(json)) return itemsOf(json).map(meaning);
  if (!isExactObject(json)) return json;
  const entries = Object.entries(json).filter(([key]) => key !== "meta" && key !== "layout");
  return Object.fromEntries(entries.sort(([a], [b]) => (a < b ? -1 : 1)).map(([key, value]) => [key, meaning(value)]));
}
const called = (list: ExactJson | undefined, name: string): ExactObject => {
  const found = itemsOf(list).filter(isExactObject).find((each) => each["state"] === name);
  if (found === undefined) throw new Error(`there is no ${name}`);
  return meaning(found) as ExactObject;
};
const hasCalibration = called(known["library"], "HasCalibration");
const recognition = called(known["library"], "ObjectRecognition");
const child = (name: string) => called(recognition["children"], name);

/** The task around it. */
const search = readExact(`{
  "state": "Search",
  "parameters": [{"name": "patience", "value": 60.0, "type": "number", "unit": "s", "doc": "So long for one search"}],
  "results": [{"name": "pose", "type": "pose"}],
  "variables": [{"name": "found", "initial": 0}],
  "actions": [{"when": "available(chi.ObjectRecognition.res.pose)", "do": "var.found += 1\\nif var.found > 0:\\n    res.pose = chi.ObjectRecognition.res.pose\\nprint(var.found)"}],
  "children": [
    {"barrier": "Start", "to": ["ObjectRecognition", "Deadline"]},
    {"state": "ObjectRecognition", "link": "ObjectRecognition", "ports": [{"name": "success"}, {"name": "lying"}, {"name": "none"}, {"name": "uncalibrated"}, {"name": "error"}]},
    {"state": "Deadline", "parameters": [{"name": "patience", "from": "par.patience"}], "ports": [{"name": "over", "after": "par.patience"}]}
  ],
  "first": "Start",
  "ports": [
    {"name": "success", "when": "chi.ObjectRecognition.port.success and available(res.pose)"},
    {"name": "error", "when": "chi.ObjectRecognition.port.error or chi.Deadline.port.over"}
  ]
}`) as ExactObject;
const wanted = meaning({ rcm: 1, library: [hasCalibration, recognition], root: search });

let fixture: Fixture;
beforeAll(async () => {
  // The demo's cell, whose camera has been calibrated.
  const cell = mkdtempSync(join(tmpdir(), "race-cell-"));
  cpSync(demo, cell, { recursive: true });
  const read = (file: string) => JSON.parse(readFileSync(join(demo, file), "utf8")) as Record<string, unknown>;
  const { pose } = read("scene.json")["camera"] as { readonly pose: unknown };
  writeFileSync(join(cell, "database.json"), JSON.stringify({ ...read("database.json"), o_t_c: pose }));
  fixture = await openFixture("--demo", cell);
  fixture.page.setDefaultTimeout(kPatience);
  await fixture.page.goto(`${fixture.url}/pro/`);
});
afterAll(() => fixture.close());

const kLong = { timeout: 60_000 };
/** All that is typed takes its time on a busy machine [ms]. */
const kForAll = 300_000;
/** The document as the server has it. */
const stored = async (): Promise<ExactObject> => (readExact(await (await fetch(`${fixture.url}/api/v1/documents/${kName}`)).text()) as ExactObject)["document"] as ExactObject;
const storedState = async (name: string): Promise<ExactJson | undefined> => {
  const find = (json: ExactJson | undefined): ExactObject | undefined =>
    !isExactObject(json) ? undefined : json["state"] === name && json["link"] === undefined ? json : itemsOf(json["children"]).map(find).find((found) => found !== undefined);
  const { library, root } = await stored();
  const found = [...itemsOf(library), root].map(find).find((each) => each !== undefined);
  return found && meaning(found);
};
/** As the demonstrator has it, without where its ports lead and what is in it. */
const alone = ({ children: _, first: __, ...state }: ExactObject): ExactObject => ({
  ...state,
  ...(state["ports"] !== undefined && { ports: itemsOf(state["ports"]).filter(isExactObject).map(({ to: ___, ...port }) => port) }),
});
const unsent = () => fixture.page.getByText(/unsent text/).count();

/** The document after it was made, and when all was built. */
let empty: ExactObject;
let built: ExactObject;

describe("ObjectRecognition, built by hand", () => {
  it("begins with an empty document and a state of the library, by mouse", async () => {
    const { page } = fixture;
    const { form, rename, fill } = mouse(page);
    await page.getByRole("button", { name: "Documents" }).click();
    await page.getByRole("button", { name: "New", exact: true }).click();
    const name = page.getByRole("textbox", { name: "Name", exact: true });
    await name.fill(kName);
    await page.getByRole("button", { name: "Create" }).click();
    await settled(page);
    empty = await stored();
    await fixture.screenshot("by-hand-empty");
    await page.getByRole("button", { name: "New library state" }).click();
    await form.getByText("State of the library").waitFor();
    await rename("HasCalibration");
    await fill(hasCalibration);
    await expect.poll(() => storedState("HasCalibration"), kLong).toEqual(hasCalibration);
    await expect.poll(() => unsent()).toBe(0);
  }, kForAll);

  it("goes on with a link and a state that are dragged into the drawing, and a line, by mouse", async () => {
    const { page } = fixture;
    const { form, canvas, rename, fill, rows, drop, lead } = mouse(page);
    await page.getByRole("button", { name: "New library state" }).click();
    await expect.poll(() => form.getByRole("textbox", { name: "Name", exact: true }).first().inputValue()).toBe("Library");
    await rename("ObjectRecognition");
    await fill({ ...alone(recognition), actions: [], ports: [] });
    await drop("HasCalibration", -150);
    await canvas.locator('[data-path="ObjectRecognition/HasCalibration"]').waitFor();
    await rename("LoadCalibration");
    for (const port of ["no", "error"]) {
      await rows("Ports").filter({ has: page.getByRole("button", { name: `Remove port ${port}` }) }).hover();
      await form.getByRole("button", { name: `Remove port ${port}` }).click();
    }
    await drop("State", 150);
    await canvas.locator('[data-path="ObjectRecognition/State"]').waitFor();
    await rename("DetectObject");
    await fill(alone(child("DetectObject")));
    await expect.poll(() => storedState("DetectObject"), kLong).toEqual(alone(child("DetectObject")));
    await settled(page);
    await fixture.screenshot("by-hand-before-line");
    await lead("ObjectRecognition/LoadCalibration.yes", "ObjectRecognition/DetectObject");
    await expect.poll(async () => writeExact((await stored())["library"] ?? null)).toContain('"to":"DetectObject"');
    await fixture.screenshot("by-hand-mouse");
    await expect.poll(() => unsent()).toBe(0);
  }, kForAll);

  it("goes on by keyboard alone: states, lines, and SaveObjectPose in the state editor", async () => {
    const { page } = fixture;
    const { keys, go, data, rest, line, toDrawing } = keyboard(page);
    // The line has left the focus in the drawing; a new state stands behind the one that is selected.
    await keys("Alt+s");
    await page.locator('#edit-canvas [data-path="ObjectRecognition/State"]').waitFor();
    await keys("F2");
    await page.keyboard.type("GetGraspPose");
    await keys("Enter", "Enter");
    await go("Description");
    await line(child("GetGraspPose")["doc"] as string);
    await data(child("GetGraspPose"));
    await rest(alone(child("GetGraspPose")));
    await expect.poll(() => storedState("GetGraspPose"), kLong).toEqual(alone(child("GetGraspPose")));

    await toDrawing();
    await keys("Alt+s");
    await page.locator('#edit-canvas [data-path="ObjectRecognition/State"]').waitFor();
    await keys("F2");
    await page.keyboard.type("SaveObjectPose");
    await keys("Enter", "Enter");
    await go("Description");
    await line(child("SaveObjectPose")["doc"] as string);
    await toDrawing();
    await keys("Shift+Enter");
    const editor = page.getByRole("region", { name: "State editor: SaveObjectPose" });
    await editor.waitFor();
    await data(child("SaveObjectPose"));
    // With the operations of the services offered as one types.
    await go("Entry");
    await page.keyboard.type("svc.db.ad");
    await page.getByRole("option", { name: /^add/ }).waitFor();
    await fixture.screenshot("by-hand-completion");
    await offered(page, "add");
    await keys("Tab");
    await page.keyboard.type("par.ke");
    await offered(page, "key");
    await keys("Tab");
    await page.keyboard.type(", par.pose");
    await keys("Control+Enter");
    await rest({ ports: child("SaveObjectPose")["ports"] ?? [] });
    await expect.poll(() => storedState("SaveObjectPose"), kLong).toEqual(child("SaveObjectPose"));
    await fixture.screenshot("by-hand-editor");
    await keys("Escape");
    await editor.waitFor({ state: "detached" });

    await expect.poll(() => heard(page)).toBe(`Drawing of ${kName}`);
    await keys("ArrowLeft", "ArrowLeft", "Control+l");
    await page.getByRole("menu", { name: "Connect to" }).waitFor();
    await fixture.screenshot("by-hand-connect");
    while ((await heard(page)) !== "success → GetGraspPose") await keys("s");
    await keys("Enter", "ArrowRight", "Control+l");
    await page.getByRole("menu", { name: "Connect to" }).waitFor();
    await page.keyboard.type("Sa");
    await keys("Enter");
    await keys("ArrowUp", "Enter");
    await rest({ actions: recognition["actions"] ?? [], ports: recognition["ports"] ?? [] });
    await expect.poll(() => storedState("ObjectRecognition"), kLong).toEqual(recognition);
    await expect.poll(() => unsent()).toBe(0);
  }, kForAll);

  it("ends with the task around it, by keyboard alone", async () => {
    const { page } = fixture;
    const { keys, go, data, rest, toDrawing } = keyboard(page);
    await toDrawing();
    await go("← search", "Shift+Tab");
    await keys("Enter");
    await go(`Drawing of ${kName}`);
    await keys("ArrowDown", "F2");
    await page.keyboard.type("Search");
    await keys("Enter", "Alt+b");
    await page.locator('#edit-canvas [data-path="Search/Barrier"]').waitFor();
    await keys("F2");
    await page.keyboard.type("Start");
    await keys("Enter");
    await go("Actions of ObjectRecognition", "Shift+Tab");
    await keys("Enter", "Enter");
    await go(`Drawing of ${kName}`);
    await keys("Alt+s", "F2");
    await page.keyboard.type("Deadline");
    await keys("Enter", "Enter");
    const [, , deadline] = itemsOf(search["children"]).filter(isExactObject);
    await data(deadline ?? {});
    await rest(deadline ?? {});
    await toDrawing();
    await keys("ArrowLeft", "ArrowLeft");
    for (const to of ["O", "D"]) {
      await keys("Control+l");
      await page.getByRole("menu", { name: "Connect to" }).waitFor();
      await keys(to, "Enter");
    }
    await keys("Shift+F10");
    await page.getByRole("menu", { name: "Actions" }).waitFor();
    await page.keyboard.type("begin");
    await keys("Enter", "ArrowUp", "Enter");
    await data(search);
    await rest(search);
    await expect.poll(async () => meaning(await stored()), kLong).toEqual(wanted);
    expect(await page.getByRole("region", { name: "Errors" }).count()).toBe(0);
    built = await stored();
    await fixture.screenshot("by-hand-built");
  }, kForAll);

  it("runs in the cell to its end, as the demonstrator's does", async () => {
    const { page } = fixture;
    await page.locator("#edit-canvas").focus();
    await page.keyboard.press("F5");
    await page.locator(".run-start").click();
    await expect.poll(() => page.getByRole("status", { name: "Run status" }).innerText(), kLong).toContain("Ended");
    await fixture.screenshot("by-hand-ended");
    const mine = await outcome(await page.getByRole("combobox", { name: "Watched run" }).inputValue());

    await fixture.send("PUT", "/documents/reference", JSON.parse(writeExact({ rcm: 1, library: known["library"] ?? [], root: { state: "Root", link: "ObjectRecognition" } })) as unknown);
    const { id } = (await fixture.send("POST", "/cores", { document: "reference", arguments: {} })) as { readonly id: string };
    await fixture.send("POST", `/cores/${id}/start`);
    await expect.poll(async () => ((await fixture.send("GET", `/cores/${id}`)) as { readonly status: string }).status, kLong).toBe("ended");
    const theirs = await outcome(id);
    expect([mine.ports, theirs.ports]).toEqual([["Search.success"], ["Root.success"]]);
    // Pictures are noisy.
    for (const i of [0, 1, 2]) expect(mine.results["Search"]?.pose?.position[i]).toBeCloseTo(theirs.results["Root"]?.pose?.position[i] ?? NaN, 2);
  }, kForAll);

  /** Presses before it is looked whether there is more; those too many are refused. */
  const kAtOnce = 8;

  it("is undone to the empty document, and redone", async () => {
    const { page } = fixture;
    await page.getByRole("tab", { name: "Edit", exact: true }).click();
    await settled(page);
    const all = async (button: string, key: string) => {
      const more = page.getByRole("button", { name: button, exact: true });
      await page.locator("#edit-canvas").focus();
      while (await more.isEnabled()) {
        for (let press = 0; press < kAtOnce; press++) await page.keyboard.press(key);
        await page.getByText(/· saved/).waitFor();
      }
      await page.getByText(/· saved/).waitFor();
    };
    await all("Undo", "Control+z");
    await expect.poll(() => stored()).toEqual(empty);
    await fixture.screenshot("by-hand-undone");
    await all("Redo", "Control+y");
    await expect.poll(() => stored()).toEqual(built);
  }, kForAll);
});

interface Outcome {
  /** Addresses of the ports that are active in the end. */
  readonly ports: readonly string[];
  readonly results: Readonly<Record<string, { readonly pose?: { readonly position: readonly number[] } }>>;
}
/** What is there when a run has ended. */
async function outcome(id: string): Promise<Outcome> {
  const { state } = (await fixture.send("GET", `/cores/${id}/state`)) as { readonly state: Outcome };
  return state;
}
