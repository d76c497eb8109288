// The display page on the real server, on a phone: tasks ask, taps answer, the core continues.
import { devices, type Page } from "playwright-core";
import { tap } from "./fingers";
import { openFixture, type Fixture } from "./fixture";
import { kSoon } from "./patience";

let fixture: Fixture;

beforeAll(async () => {
  fixture = await openFixture();
});
afterAll(() => fixture.close());

type Json = Readonly<Record<string, unknown>>;

async function request(method: string, path: string, body?: Json): Promise<Json> {
  const init = body === undefined ? { method } : { method, body: JSON.stringify(body), headers: { "content-type": "application/json" } };
  const answer = await fetch(`${fixture.url}/api/v1${path}`, init);
  const json = (await answer.json()) as Json;
  if (!answer.ok) throw new Error(JSON.stringify(json));
  return json;
}

/** Runs a task with this root state; gives its id. */
async function runTask(root: Json): Promise<string> {
  await request("PUT", "/documents/asking", { rcm: 1, name: "asking", root });
  const { id } = await request("POST", "/cores", { document: "asking", arguments: {} });
  await request("POST", `/cores/${String(id)}/start`);
  return String(id);
}

/** A task that calls an operation: `answered` with its result, or `failed` with its error. */
function run(call: string): Promise<string> {
  const operation = `svc.${call.slice(0, call.indexOf("("))}`;
  return runTask({
    state: "Root",
    entry: `svc.${call}`,
    results: [{ name: "answer" }, { name: "code" }],
    actions: [
      { when: `${operation}.result`, do: `res.answer = ${operation}.result` },
      { when: `${operation}.error`, do: `res.code = ${operation}.error.code` },
    ],
    ports: [
      { name: "answered", when: "available(res.answer)" },
      { name: "failed", when: "available(res.code)" },
    ],
  });
}

/** A task that waits for a press of a button that is shown. */
const listen = (): Promise<string> =>
  runTask({
    state: "Root",
    results: [{ name: "answer" }],
    actions: [{ when: "svc.display.button", do: "res.answer = svc.display.button" }],
    ports: [{ name: "heard", when: "available(res.answer)" }],
  });

/** What the task found, once it has ended. */
async function outcome(core: string): Promise<unknown> {
  let found: Json = {};
  await expect.poll(async () => (found = await request("GET", `/cores/${core}`))["status"], kSoon).toBe("ended");
  const results = found["results"] as Json;
  return results["answer"] ?? results["code"];
}

/** A phone that is the display `name`; it closes with its context. */
async function phone(name?: string, colorScheme: "light" | "dark" = "light"): Promise<Page> {
  const context = await fixture.openContext({ ...devices["Pixel 7"], colorScheme });
  const page = await context.newPage();
  await page.goto(`${fixture.url}/display/${name === undefined ? "" : `?name=${name}`}`);
  await status(page, "Connected");
  return page;
}

const status = (page: Page, text: string) => page.getByRole("status", { name: "Connection" }).filter({ hasText: text }).waitFor();
const button = (page: Page, name: string) => page.getByRole("button", { name, exact: true });

describe("a phone as display", () => {
  let page: Page;
  afterEach(() => page.context().close());

  /** A key of the keypad, with what the field says then. */
  async function press(key: string, entry: string): Promise<void> {
    await tap(button(page, key));
    await expect.poll(() => page.getByRole("status", { name: "Number" }).textContent()).toBe(`${entry}m`);
  }

  it("asks, and the core goes on with the button that a finger taps", async () => {
    page = await phone();
    const core = await run("display.ask('The arm has touched something. What now?', ['Continue', 'Skip this part', 'Abort'])");
    await button(page, "Skip this part").waitFor();
    await fixture.screenshot("display-question", page);
    await tap(button(page, "Skip this part"));
    expect(await outcome(core)).toEqual({ answer: "Skip this part", display: "main" });
    await page.getByText("main", { exact: true }).nth(1).waitFor();
    await expect.poll(() => page.getByRole("region", { name: "Question" }).count()).toBe(0);
  });

  it("shows how much is done, at the place in its address", async () => {
    const context = await fixture.openContext({ ...devices["Pixel 7"] });
    page = await context.newPage();
    await page.goto(`${fixture.url}/display/?name=arm&place=gripper`);
    await status(page, "Connected");
    await run("display.show_progress('Calibrating the camera', 0.4, display='@gripper')");
    const bar = page.getByRole("progressbar", { name: "Calibrating the camera" });
    await bar.waitFor();
    await expect.poll(() => bar.evaluate((element) => (element as HTMLProgressElement).position)).toBeCloseTo(0.4);
    await page.getByText("40 %", { exact: true }).waitFor();
    await fixture.screenshot("display-progress", page);
    await run("display.show_text('Done', display='@gripper')");
    await page.getByText("Done", { exact: true }).waitFor();
    await expect.poll(() => bar.count()).toBe(0);
  });

  it("has buttons large enough for a thumb, all within the screen", async () => {
    page = await phone();
    await run("display.ask_number('How wide is the part?', -0.5, 0.11, 'm')");
    const keys = page.getByRole("region", { name: "Question" }).getByRole("button");
    await button(page, "Sign").waitFor();
    const screen = page.viewportSize() ?? { width: 0, height: 0 };
    for (const key of await keys.all()) {
      const box = await key.boundingBox();
      expect(box?.height).toBeGreaterThanOrEqual(48); // [px], what a finger needs
      expect(box?.width).toBeGreaterThanOrEqual(48);
      expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(screen.width);
      expect((box?.y ?? 0) + (box?.height ?? 0)).toBeLessThanOrEqual(screen.height);
    }
  });

  it("takes a number from its keypad, within the limits only", async () => {
    page = await phone("main", "dark");
    const core = await run("display.ask_number('How wide is the part?', 0.0, 0.11, unit='m')");
    // Not the question of the test before, whose run still waits.
    await expect.poll(() => page.getByRole("status", { name: "Number" }).textContent()).toBe("0 to 0.11 m");
    await press("Point", "0.");
    await press("2", "0.2");
    await page.getByText("At most 0.11 m").waitFor();
    await expect.poll(() => button(page, "OK").isDisabled()).toBe(true);
    await press("Delete", "0.");
    await press("0", "0.0");
    await press("4", "0.04");
    await fixture.screenshot("display-number", page);
    await tap(button(page, "OK"));
    expect(await outcome(core)).toEqual({ answer: 0.04, display: "main" });
  });

  it("shows an image with its text, and reports each press of its buttons", async () => {
    page = await phone();
    const drawing = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 200"><rect width="400" height="200" fill="#d8e6dc"/><circle cx="200" cy="100" r="60" fill="#e0b100"/></svg>`;
    const url = `data:image/svg+xml;base64,${Buffer.from(drawing).toString("base64")}`;
    await outcome(await run(`display.show_image('${url}', 'Is this the tape?', ['Help'])`));
    await expect.poll(() => page.locator("img").evaluate((image) => image instanceof HTMLImageElement && image.naturalWidth)).toBeGreaterThan(0);
    const core = await run("display.ask('Confirm it.')");
    await button(page, "OK").waitFor();
    await fixture.screenshot("display-image", page);
    const listening = await listen();
    await tap(button(page, "Help"));
    expect(await outcome(listening)).toEqual({ button: "Help", display: "main" });
    await tap(button(page, "OK"));
    expect(await outcome(core)).toEqual({ answer: "OK", display: "main" });
    await run("display.clear()");
    await page.locator("img").waitFor({ state: "detached" });
  });
});

describe("several displays", () => {
  it("show what their name is asked, and one of them answers for all", async () => {
    const [left, right] = [await phone("left"), await phone("right")];
    const named = await run("display.ask('Only here?', display='right')");
    await right.getByText("Only here?").waitFor();
    expect(await left.getByText("Only here?").count()).toBe(0);
    await tap(button(right, "OK"));
    expect(await outcome(named)).toEqual({ answer: "OK", display: "right" });
    const both = await run("display.choose('Which way?', ['This', 'That'])");
    await button(right, "This").waitFor();
    await tap(button(left, "That"));
    expect(await outcome(both)).toBe("That");
    await right.getByText("Which way?").waitFor({ state: "detached" });
    await left.context().close();
    await right.context().close();
  });

  it("that are closed for good while a question waits are an error of the question", async () => {
    const page = await phone("left");
    const core = await run("display.ask('Still there?')");
    await page.getByText("Still there?").waitFor();
    await page.context().close();
    expect(await outcome(core)).toBe("display_lost");
    expect(await outcome(await run("display.ask('Anybody?')"))).toBe("no_display");
  });

  it("that are loaded again still show their question", async () => {
    const page = await phone("left");
    const core = await run("display.ask('Still there?')");
    await page.getByText("Still there?").waitFor();
    await page.reload();
    await tap(button(page, "OK"));
    expect(await outcome(core)).toEqual({ answer: "OK", display: "left" });
    await page.context().close();
  });
});

describe("sounds", () => {
  it("are played after the first touch, and the core gets their end", async () => {
    const page = await phone();
    await page.getByText("Touch the screen once to hear sounds.").waitFor();
    expect(await outcome(await run("audio.play('beep')"))).toBe("no_speaker");
    await tap(page.getByRole("main"));
    await page.getByText("Touch the screen once to hear sounds.").waitFor({ state: "detached" });
    expect(await outcome(await run("audio.play('success', 0.5, 2)"))).toEqual({ sound: "success", displays: ["main"] });
    await page.context().close();
  });
});

describe("a lost connection", () => {
  it("is shown on the page until the server is back", async () => {
    const page = await phone();
    await run("display.ask('Go on?')");
    await button(page, "OK").waitFor();
    await fixture.kill();
    await status(page, "Connection lost");
    await expect.poll(() => button(page, "OK").isDisabled()).toBe(true);
    await fixture.screenshot("display-lost", page);
    await fixture.restart();
    await status(page, "Connected");
    // The new server does not know the question.
    await page.getByText("Go on?").waitFor({ state: "detached" });
    const core = await run("display.ask('And now?')");
    await tap(button(page, "OK"));
    expect(await outcome(core)).toEqual({ answer: "OK", display: "main" });
    await page.context().close();
  });

  it("is not reported for an invalid name", async () => {
    const context = await fixture.openContext({ ...devices["Pixel 7"] });
    const page = await context.newPage();
    await page.goto(`${fixture.url}/display/?name=all`);
    await page.getByText("The name of a display").waitFor();
    await context.close();
  });
});
