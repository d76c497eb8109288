// RACE-One: a step fails for its place, which is taught again while the run waits, or after its end; then the arm goes there. On the real server.
import type { Locator, Page } from "playwright-core";
import { openFixture, type Fixture } from "./fixture";
import { prepareToMove } from "./prepare";
import { kPatience } from "./patience";

/** [m] */
const kRaised = 0.005;

let fixture: Fixture;
let page: Page;
beforeAll(async () => {
  fixture = await openFixture();
  page = await (await fixture.openContext({ viewport: { width: 1366, height: 768 }, reducedMotion: "reduce", colorScheme: "light" })).newPage();
  page.setDefaultTimeout(kPatience);
  await fixture.send("PUT", "/documents/shelf", { rcm: 1, name: "shelf", root: { state: "Application", meta: { id: "root" } } });
  await page.goto(`${fixture.url}/one/?edit=shelf`);
  await page.getByLabel("Name of the task").fill("Go to the shelf");
  await page.getByRole("button", { name: "Add the task" }).click();
  await page.locator('[data-skill="MoveTo"]').click();
  await goTo("shelf");
});
afterAll(() => fixture.close());

const button = (name: string) => page.getByRole("button", { name, exact: true });
const panel = () => page.getByRole("complementary", { name: "What is selected" });
const card = () => page.locator(".step > .card > .card-open", { has: page.locator("strong", { hasText: /^Move to a pose$|^Move to$/ }) });
const teaching = (pose: string) => page.getByRole("region", { name: `Teach “${pose}” again` });
const status = () => page.getByRole("status", { name: "Run status" }).innerText();
const call = async (service: string, operation: string, kwargs: unknown = {}) => ((await fixture.send("POST", `/services/${service}/calls`, { operation, kwargs })) as { readonly result: { readonly pose: { readonly position: readonly number[] } } }).result.pose.position[2] ?? Number.NaN;
/** Of the tool, and of a taught pose [m]. */
const height = () => call("robot", "state");
const taught = (pose: string) => call("db", "get", { key: `pose_${pose}` });

async function goTo(pose: string): Promise<void> {
  await panel().getByLabel("Pose", { exact: true }).selectOption({ label: "Another…" });
  await panel().getByLabel("Pose: name of the pose").fill(pose);
  await panel().getByRole("button", { name: "Use it" }).click();
  await page.getByText(`“${pose}” is not taught yet.`).first().waitFor();
}

/** Holds the button until the arm is so much higher, or lower; who sees that nothing moves lets go, and presses again. */
async function raise(within: Locator, by: number): Promise<void> {
  const goal = (await height()) + by;
  const isThere = async () => Math.sign(by) * ((await height()) - goal) >= 0;
  for (let tries = 0; tries < 5 && !(await isThere()); tries++) {
    await prepareToMove(page);
    const held = within.getByRole("button", { name: by > 0 ? "Up, tool along Z plus, while held" : "Down, tool along Z minus, while held", exact: true });
    await held.scrollIntoViewIfNeeded();
    await held.focus();
    await page.keyboard.down("Space");
    for (const end = Date.now() + 5000; Date.now() < end && !(await held.isDisabled()) && !(await isThere()); );
    await page.keyboard.up("Space");
  }
  expect(await isThere(), `it is moved by ${by} m`).toBe(true);
}

/** Teaches `pose` where the arm is lifted to, and leaves that place; the height of the pose [m]. */
async function teach(pose: string): Promise<number> {
  const part = teaching(pose);
  await part.waitFor();
  await raise(part, kRaised);
  await part.getByRole("button", { name: `Save “${pose}” here` }).click();
  await part.getByText(`Saved as ${pose}.`).waitFor();
  const at = await taught(pose);
  await raise(part, 2 * kRaised);
  return at;
}

describe("a place that is taught again", () => {
  it("is saved while the run waits, and the step is tried again there", async () => {
    await panel().getByRole("radio", { name: "Ask a person" }).check();
    await card().getByText("if it fails: ask").waitFor();
    await button("Run").click();
    await button("Start").click();
    await button("Teach it again").click();
    await teaching("shelf").waitFor();
    await expect.poll(() => status()).toBe("Paused");
    await expect.poll(() => button("Try the step again").isDisabled(), { message: "nothing is saved yet" }).toBe(true);
    await prepareToMove(page);
    await button("Do not teach").click();
    await button("Teach it again").click();
    const at = await teach("shelf");
    await fixture.screenshot("one-teach-again", page);
    await button("Try the step again").click();
    await page.getByRole("heading", { name: "All done" }).waitFor();
    await expect.poll(() => height()).toBeCloseTo(at, 3);
    await page.getByText(/^Move to.*Tried again\.$/).waitFor();
    expect(((await fixture.send("GET", "/control")) as { readonly mode: string }).mode, "as before").toBe("execution");
  });

  it("is saved after the end of the run, which then begins anew", async () => {
    await button("Build").click();
    await card().click();
    await goTo("box");
    await panel().getByRole("radio", { name: "Stop the task" }).check();
    await button("Run").click();
    await button("Start again").click();
    await button("Teach it again").click();
    const at = await teach("box");
    await button("Start again").last().click();
    await page.getByRole("heading", { name: "All done" }).waitFor();
    await expect.poll(() => height()).toBeCloseTo(at, 3);
  });
});
