// The demonstrator (thesis, appendix A) with its operator by script: what the pages show until it has handled a collision.
import { join } from "node:path";
import { devices, type Page } from "playwright-core";
import { activations, noteActivations } from "./activations";
import { demo, openFixture, settled, type Fixture } from "./fixture";
import { letMove } from "./hands";
import { kSoon } from "./patience";

let fixture: Fixture;
let task: Page;
let services: Page;
let phone: Page;
let core: string;

beforeAll(async () => {
  fixture = await openFixture("--operator", join(demo, "operator.json"));
  phone = await (await fixture.openContext({ ...devices["Pixel 7"] })).newPage();
  await phone.goto(`${fixture.url}/display/?name=second`);
  await phone.getByRole("status", { name: "Connection" }).filter({ hasText: "Connected" }).waitFor();
  task = await fixture.openPage({ width: 1280, height: 800 });
  services = await fixture.openPage({ width: 1280, height: 800 });
  await services.getByRole("tab", { name: "Services" }).click();
  await letMove(task, "demonstrator");
  await task.getByRole("combobox", { name: "Document" }).selectOption("demonstrator");
  await task.getByRole("button", { name: "Load" }).click();
  for (const composite of ["Table", "Table/Work"]) {
    await settled(task);
    await task.getByRole("button", { name: `Expand Demonstrator/${composite}`, exact: true }).click();
  }
  await state("Table/Work/Collision").waitFor();
  core = await task.getByRole("combobox", { name: "Watched run" }).inputValue();
  await noteActivations(task);
});
afterAll(() => fixture.close());

const kLong = { timeout: 60_000 };
const state = (path: string) => task.locator(`.canvas [data-path="Demonstrator/${path}"]`);
const turns = (path: string, active: boolean) => expect.poll(() => state(path).getAttribute("data-active"), kLong).toBe(String(active));
const running = () => task.getByRole("region", { name: "Running now" });

async function serverStep(): Promise<number> {
  const found = (await (await fetch(`${fixture.url}/api/v1/cores/${core}`)).json()) as { readonly step: number };
  return found.step;
}
const shownStep = async () => Number(/step (\d+)/.exec(await task.getByRole("status", { name: "Run status" }).innerText())?.[1]);

/** Waits until the page shows the current state of the server. */
async function keepsUp(): Promise<void> {
  const step = await serverStep();
  await expect.poll(shownStep, kSoon).toBeGreaterThanOrEqual(step);
}

describe("the demonstrator with an operator by script", () => {
  it("calibrates first, with instructions on every display", async () => {
    await task.getByRole("button", { name: "Start", exact: true }).click();
    await turns("Calibration", true);
    expect(await state("Table").getAttribute("data-active")).toBe("false");
    await phone.getByText(/Lead the arm/).waitFor();
    await running().getByTitle(/Calibration\/CameraCalibration/).waitFor();
    await fixture.screenshot("demonstrator-calibration", task);
  });

  it("sends pictures of the camera to recognition meanwhile", async () => {
    const flow = services.locator('[data-flow="camera.frame:obj_rec"]');
    await expect.poll(() => flow.getAttribute("class"), kLong).toBe("flow is-flowing");
    await expect.poll(() => flow.locator("text").textContent(), kLong).toMatch(/^frame \d+\.\d\/s$/);
    await fixture.screenshot("demonstrator-services", services);
  });

  it("is followed by the page while it also draws the cell, large and small", async () => {
    await keepsUp();
    await task.getByRole("tab", { name: "Cell" }).click();
    await task.getByText(/^cell time/).waitFor();
    await keepsUp();
    await fixture.screenshot("demonstrator-cell", task);
    await task.getByRole("tab", { name: "Task" }).click();
    await state("Table/Work/Collision").waitFor();
    await noteActivations(task);
  });

  it("goes on to Table when the camera is calibrated", async () => {
    await turns("Table", true);
    await turns("Calibration", false);
    await turns("Table/Work", true);
  });

  it("shows a collision, asks on every display, and continues after an answer", async () => {
    // The operator answers after 1.5 s: all is looked for at once.
    await Promise.all([
      phone.getByRole("heading", { name: "What is to be done?" }).waitFor(kLong),
      ...["Continue", "Skip", "Abort"].map((name) => phone.getByRole("button", { name, exact: true, disabled: false }).waitFor(kLong)),
      task.getByRole("alert", { name: "Waiting for a person" }).getByText(/Waiting for a person: .*What is to be done/).waitFor(kLong),
      task.getByRole("status", { name: "Run status" }).filter({ hasText: "Waiting for a person" }).waitFor(kLong),
    ]);
    await fixture.screenshot("demonstrator-question", phone);
    await fixture.screenshot("demonstrator-collision", task);
    await phone.getByRole("heading", { level: 2 }).waitFor({ state: "detached" });
    await turns("Table/Work/Collision", false);
    await turns("Table/Work/Task", true);
    expect(await activations(task)).toEqual(expect.arrayContaining(["Demonstrator/Table/Work/Task", "Demonstrator/Table/Work/Collision"]));
    await keepsUp();
  });

  it("ends on demand, without an error on any page", async () => {
    await task.getByRole("button", { name: "Stop", exact: true }).click();
    await expect.poll(() => task.getByRole("status", { name: "Run status" }).innerText(), kSoon).toMatch(/Stopped/);
  });
});
