// A cell in a process of its own: the process starts after the page, is killed, and another one starts with another scene.
import { spawn, type ChildProcess } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { find, view, type Place, type Region } from "./pointer";
import { binary, demo, openFixture, type Fixture } from "./fixture";
import { kSoon } from "./patience";

let fixture: Fixture;
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
  fixture = await openFixture("--remote", "cell", "--heartbeat", "30");
  // The page asks for the cell while its process is not there.
  fixture.allowError(/^Failed to load resource: the server responded with a status of 503 .*\/api\/v1\/cell/);
  await fixture.page.setViewportSize({ width: 1000, height: 640 });
  await fixture.page.goto(`${fixture.url}/pro/`);
  await fixture.page.getByRole("tab", { name: "Cell" }).click();
  await view(fixture.page).waitFor(kSoon);
  await button("Parts").click();
  await button("Pull").click();
});
afterAll(async () => {
  await end();
  await fixture.close();
  rmSync(crated, { recursive: true, force: true });
});

const kTable: Region = [0.42, 0.68, 0.56, 0.78];
const kCrate: Region = [0.48, 0.54, 0.6, 0.75];
/** Where a part of the demo is [px]. */
let place: Place;
const button = (name: string) => fixture.page.getByRole("button", { name, exact: true });
const away = () => fixture.page.getByText("The cell cannot be shown: its process is not there", { exact: true });
const listed = () => fixture.page.getByRole("list", { name: "Parts" }).locator("span").allInnerTexts();
const clock = () => fixture.page.getByText(/^cell time/);

function begin(folder: string): void {
  process = spawn(binary, ["service", "cell", "--server", fixture.url, "--folder", folder, "--token-file", join(fixture.data, "processes.token")], { stdio: ["ignore", "ignore", "inherit"] });
}

async function end(): Promise<void> {
  const ended = new Promise((resolve) => process?.once("exit", resolve));
  if (process?.kill("SIGKILL") === true) await ended;
  process = undefined;
}

describe("a cell that is a process", () => {
  it("is reported as missing before it starts", async () => {
    await away().waitFor(kSoon);
    await expect.poll(() => listed(), kSoon).toEqual([]);
  });

  it("is shown as soon as it is connected, without a reload", async () => {
    begin(demo);
    await expect.poll(listed, kSoon).toEqual(parts);
    await away().waitFor({ ...kSoon, state: "detached" });
    await clock().waitFor(kSoon);
    await button("Parts").click();
    place = await find(fixture.page, new RegExp(`^(${parts.join("|")})$`), kTable);
    await button("Parts").click();
  });

  it("is removed from the page when its process is killed", async () => {
    await end();
    await away().waitFor(kSoon);
    await expect.poll(() => listed(), kSoon).toEqual([]);
    await clock().waitFor({ ...kSoon, state: "detached" });
    await fixture.screenshot("cell-away");
  });

  it("is replaced when another process is connected", async () => {
    begin(crated);
    await expect.poll(listed, kSoon).toEqual(["crate"]);
    await clock().waitFor(kSoon);
    await button("Parts").click();
    await find(fixture.page, /^crate$/, kCrate);
    await fixture.page.mouse.move(place.x, place.y);
    await expect.poll(async () => parts.includes((await view(fixture.page).getAttribute("title")) ?? ""), kSoon).toBe(false);
    expect(await button("Put back crate").count()).toBe(0);
    await fixture.screenshot("cell-crate");
  });
});
