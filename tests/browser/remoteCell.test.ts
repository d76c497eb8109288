// A page that shows a cell in a process of its own: the process comes later than the page, dies, and another one comes with another scene.
import { spawn, type ChildProcess } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { find, view, type Place, type Region } from "./pointer";
import { binary, demo, openStage, type Stage } from "./stage";

let stage: Stage;
let process: ChildProcess | undefined;
/** The demo's robot and table, and nothing on it but a crate. */
const crated = mkdtempSync(join(tmpdir(), "race-crate-"));

interface SceneFile {
  readonly bodies: readonly { readonly name: string; readonly mass: number }[];
}
const scene = JSON.parse(readFileSync(join(demo, "scene.json"), "utf8")) as SceneFile;
const parts = scene.bodies.filter(({ mass }) => mass > 0).map(({ name }) => name);
const crate = { name: "crate", shape: { box: [0.3, 0.3, 0.3] }, mass: 5, friction: 0.8, colour: "#8d6e4f", pose: { position: [0.6, -0.3, 0.15], orientation: [0, 0, 0, 1] } };

beforeAll(async () => {
  cpSync(demo, crated, { recursive: true });
  writeFileSync(join(crated, "scene.json"), JSON.stringify({ ...scene, bodies: [...scene.bodies.filter(({ mass }) => mass === 0), crate] }));
  // A machine under load may be slow: no process is lost because of that.
  stage = await openStage("--remote", "cell", "--heartbeat", "30");
  await stage.page.setViewportSize({ width: 1000, height: 640 });
  await stage.page.goto(`${stage.url}/pro/`);
  await stage.page.getByRole("tab", { name: "Cell" }).click();
  await view(stage.page).waitFor(kSoon);
  await button("Parts").click();
  await button("Pull").click();
});
afterAll(async () => {
  await end();
  await stage.close();
  rmSync(crated, { recursive: true, force: true });
});

const kSoon = { timeout: 45_000 };
const kTable: Region = [0.42, 0.68, 0.56, 0.78];
const kCrate: Region = [0.48, 0.54, 0.6, 0.75];
/** Where a part of the demo is [px]. */
let place: Place;
const button = (name: string) => stage.page.getByRole("button", { name, exact: true });
const away = () => stage.page.getByText("The cell cannot be shown: its process is not there", { exact: true });
const listed = () => stage.page.getByRole("list", { name: "Parts" }).locator("span").allInnerTexts();
const clock = () => stage.page.getByText(/^cell time/);

function begin(folder: string): void {
  process = spawn(binary, ["service", "cell", "--server", stage.url, "--folder", folder], { stdio: ["ignore", "ignore", "inherit"] });
}

async function end(): Promise<void> {
  const ended = new Promise((resolve) => process?.once("exit", resolve));
  if (process?.kill("SIGKILL") === true) await ended;
  process = undefined;
}

describe("a cell that is a process", () => {
  it("is missed by a page that was there before it", async () => {
    await away().waitFor(kSoon);
    expect(await listed()).toEqual([]);
  });

  it("is shown as soon as it comes, without a touch of the page", async () => {
    begin(demo);
    await expect.poll(listed, kSoon).toEqual(parts);
    await away().waitFor({ ...kSoon, state: "detached" });
    await clock().waitFor(kSoon);
    await button("Parts").click();
    place = await find(stage.page, new RegExp(`^(${parts.join("|")})$`), kTable);
    await button("Parts").click();
  });

  it("is gone from the page when it dies", async () => {
    await end();
    await away().waitFor(kSoon);
    expect(await listed()).toEqual([]);
    expect(await clock().count()).toBe(0);
    await stage.picture("cell-away");
  });

  it("is shown anew when another one comes: its parts, and none of the last", async () => {
    begin(crated);
    await expect.poll(listed, kSoon).toEqual(["crate"]);
    await clock().waitFor(kSoon);
    await button("Parts").click();
    await find(stage.page, /^crate$/, kCrate);
    await stage.page.mouse.move(place.x, place.y);
    expect(parts).not.toContain(await view(stage.page).getAttribute("title"));
    expect(await button("Put back crate").count()).toBe(0);
    await stage.picture("cell-crate");
  });
});
