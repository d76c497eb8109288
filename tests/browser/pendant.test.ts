// The teach pendant on a phone, on the real server and cell: the arm is jogged, led by hand and sent to poses while a button is held; tasks are run.
import { devices, type Locator, type Page } from "playwright-core";
import { watchArm, type Arm } from "./arm";
import { findings } from "./axe";
import { expectStill, otherPerson, slowRobot, type Coming } from "./comes";
import { openFixture, type Fixture } from "./fixture";

const kSoon = { timeout: 20_000 };
/** A joint that turns by hand, slowly, does so by more than this between two poses [rad]. */
const kSlow = 1e-4;
/** What a finger needs [px]. */
const kTarget = 44;

const kStart = [0, -0.35, 0, 1.6, 0, -1.19, 0];
const move = (base: number, speed: number) => `svc.robot.move({'joints': [${[base, ...kStart.slice(1)].join(", ")}]}, speed=${speed})`;
const turn = (state: string, other: string, base: number) => ({ state, entry: move(base, 0.2), ports: [{ name: "next", when: "svc.robot.move.result", to: other }, { name: "failed", when: "svc.robot.move.error" }] });
/** Moves to and fro. */
const toAndFro = { rcm: 1, name: "toAndFro", root: { state: "Root", doc: "Turns the arm to and fro.", first: "TurnLeft", children: [turn("TurnLeft", "TurnRight", 0.6), turn("TurnRight", "TurnLeft", -0.6)] } };

/** Asks after a while, so that a person can go to another view before. */
const asksLater = {
  rcm: 1,
  name: "asksLater",
  root: {
    state: "Root",
    first: "Wait",
    children: [
      { state: "Wait", ports: [{ name: "next", after: "8.0", to: "Ask" }] },
      { state: "Ask", entry: "svc.display.ask('Is there a part in the gripper, and is the cell clear of people?', ['Yes'], display='phone1')", ports: [{ name: "done", when: "svc.display.ask.result" }] },
    ],
    ports: [{ name: "done", when: "chi.Ask.port.done" }],
  },
};

interface Answer {
  readonly result: { readonly pose: { readonly position: readonly number[] } };
}

describe("a phone as teach pendant", () => {
  let fixture: Fixture;
  let page: Page;
  let arm: Arm;
  beforeAll(async () => {
    fixture = await openFixture();
    arm = watchArm(fixture.url, kSlow);
    await fixture.send("PUT", "/documents/toAndFro", toAndFro);
    await fixture.send("PUT", "/documents/asksLater", asksLater);
  });
  afterAll(async () => {
    arm.close();
    await fixture.close();
  });
  beforeEach(async () => {
    page = await (await fixture.openContext({ ...devices["Pixel 7"] })).newPage();
    page.setDefaultTimeout(20_000);
  });
  afterEach(async () => {
    await page.context().close();
    await fixture.send("POST", "/stop");
    await fixture.send("POST", "/stop/reset");
  });

  const button = (name: string) => page.getByRole("button", { name, exact: true });
  const mode = async () => ((await fixture.send("GET", "/control")) as { readonly mode: string }).mode;

  async function open(hash: string): Promise<void> {
    await page.goto(`${fixture.url}/display/?name=phone1${hash}`);
    await page.getByRole("status", { name: "Connection" }).filter({ hasText: "Connected" }).waitFor();
  }

  /** The person takes the controls, and chooses the mode in which the arm is moved by hand. */
  async function prepare(part: string): Promise<void> {
    await open(`#move/${part}`);
    const before = page.getByRole("region", { name: "Before you move the robot" });
    await before.getByRole("button", { name: "Take the controls" }).tap();
    await page.getByText("You have the controls").waitFor();
    if ((await mode()) !== "programming") await before.getByRole("button", { name: "Programming" }).tap();
    await before.waitFor({ state: "detached" });
  }

  /** A finger on a button; the result lifts it. */
  async function hold(name: string): Promise<() => Promise<void>> {
    const session = await page.context().newCDPSession(page);
    const held = button(name);
    await held.scrollIntoViewIfNeeded();
    const box = await held.boundingBox();
    if (box === null) throw new Error(`${name} is not on the screen`);
    await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x: box.x + box.width / 2, y: box.y + box.height / 2 }] });
    return async () => void (await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] }));
  }

  const moves = (wanted: boolean) => expect.poll(arm.moves, kSoon).toBe(wanted);

  /** `part`: of a page that has the controls, and has them afterwards. Everything that is pressed is large enough, on the screen, and axe-core finds nothing. */
  async function looksGood(name: string, part?: string): Promise<void> {
    await fixture.screenshot(name, page);
    const width = page.viewportSize()?.width ?? 0;
    for (const target of await page.locator("button:visible, nav a:visible, input:not([type=checkbox]):visible, label:has(input[type=checkbox]):visible").all()) {
      const box = await target.boundingBox();
      const text = `${name}: ${(await target.getAttribute("aria-label")) ?? (await target.textContent()) ?? ""}`;
      expect(Math.round(box?.height ?? 0), text).toBeGreaterThanOrEqual(kTarget);
      expect(Math.round(box?.width ?? 0), text).toBeGreaterThanOrEqual(kTarget);
      expect((box?.x ?? 0) + (box?.width ?? 0), text).toBeLessThanOrEqual(width);
    }
    expect(await findings(page), name).toEqual([]);
    // The search for findings keeps the page from its signs of life.
    if (part === undefined) return;
    await page.goto("about:blank");
    await prepare(part);
  }

  it("is a light page: 300 kB at most, as they come over the network", async () => {
    const session = await page.context().newCDPSession(page);
    await session.send("Network.enable");
    let bytes = 0;
    session.on("Network.loadingFinished", ({ encodedDataLength }) => (bytes += encodedDataLength));
    await open("#move");
    await page.waitForLoadState("networkidle").catch(() => undefined);
    console.log(`the page of a phone: ${Math.round(bytes / 1024)} kB`);
    expect(bytes).toBeGreaterThan(20 * 1024);
    expect(bytes).toBeLessThan(300 * 1024);
  });

  it("says what is missing before the arm is moved by hand", async () => {
    await open("#move");
    const joint = button("Joint 1 plus, while held");
    await joint.waitFor();
    expect(await joint.isDisabled()).toBe(true);
    await looksGood("pendant-before");
  });

  it("moves a joint while a finger holds the button, slowly at first, and no longer", async () => {
    await prepare("joints");
    await looksGood("pendant-joints", "joints");
    const lift = await hold("Joint 1 plus, while held");
    await moves(true);
    await fixture.screenshot("pendant-held", page);
    await lift();
    await moves(false);
  });

  it("moves the tool along its own axes", async () => {
    await prepare("tool");
    await looksGood("pendant-tool", "tool");
    await button("Axes of the tool").tap();
    const lift = await hold("Back off, tool along Z minus, while held");
    await moves(true);
    await lift();
    await moves(false);
  });

  it("moves nothing by a second finger and says so, and stops what the first one moves", async () => {
    await prepare("joints");
    const session = await page.context().newCDPSession(page);
    const at = async (on: Locator) => {
      const box = await on.boundingBox();
      if (box === null) throw new Error(`${String(on)} is not on the screen`);
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    };
    const touch = (type: "touchStart" | "touchEnd", ...points: readonly { readonly x: number; readonly y: number }[]) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map((point, id) => ({ ...point, id })) });
    const said = page.getByText("Not moved: more than one finger is on the screen. Lift all of them, then press with one.");
    const first = button("Joint 1 plus, while held");
    const [thumb, second] = [await at(page.getByText("Joint 4", { exact: true })), await at(button("Joint 2 plus, while held"))];
    await touch("touchStart", thumb);
    await touch("touchStart", thumb, await at(first));
    await said.waitFor();
    await fixture.screenshot("pendant-two-fingers", page);
    await page.waitForTimeout(500);
    expect(arm.moves()).toBe(false);
    await touch("touchEnd");
    const pressed = await at(first);
    await touch("touchStart", pressed);
    await moves(true);
    expect(await said.count()).toBe(0);
    await touch("touchStart", pressed, second);
    await said.waitFor();
    await moves(false);
    await touch("touchEnd");
    // Not on a button, too.
    await touch("touchStart", pressed);
    await moves(true);
    expect(await said.count()).toBe(0);
    await touch("touchStart", pressed, thumb);
    await said.waitFor();
    await moves(false);
    await touch("touchEnd");
  });

  it.each([
    ["upright", devices["Pixel 7"]],
    ["small", { ...devices["Pixel 7"], viewport: { width: 360, height: 640 } }],
    ["on its side", devices["Pixel 7 landscape"]],
  ])("leaves the buttons that move the arm where they are, whatever comes by itself: %s", async (name, device) => {
    await page.context().close();
    page = await (await fixture.openContext({ ...device })).newPage();
    page.setDefaultTimeout(20_000);
    await prepare("joints");
    const views = page.getByRole("navigation", { name: "Views of phone1" });
    await views.getByRole("link", { name: "Run" }).tap();
    await button("Start asksLater").tap();
    await page.getByRole("region", { name: "Run of asksLater" }).first().waitFor();
    await views.getByRole("link", { name: "Move" }).tap();
    const first = button("Joint 1 plus, while held");
    await first.scrollIntoViewIfNeeded();
    const asks = page.getByRole("region", { name: "A task asks" });
    expect(await asks.count(), "it has not asked yet").toBe(0);
    const question: Coming = {
      what: "a question",
      comes: () => asks.waitFor(),
      goes: async () => {
        await fixture.screenshot(`pendant-still-${name.replaceAll(" ", "-")}`, page);
        const other = await (await fixture.openContext({ ...devices["Pixel 7"] })).newPage();
        await other.goto(`${fixture.url}/display/?name=phone1#show`);
        await other.getByRole("button", { name: "Yes", exact: true }).tap();
        await asks.waitFor({ state: "detached" });
        await other.context().close();
      },
    };
    const session = await page.context().newCDPSession(page);
    const touch = (type: "touchStart" | "touchEnd", ...points: readonly { readonly x: number; readonly y: number }[]) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map((point, id) => ({ ...point, id })) });
    const middle = async (on: Locator) => {
      const box = await on.boundingBox();
      if (box === null) throw new Error(`${String(on)} is not on the screen`);
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    };
    const [thumb, pressed] = [await middle(page.getByText("Joint 1", { exact: true })), await middle(first)];
    const said = page.getByText(/^Not moved: more than one finger/);
    const twoFingers: Coming = {
      what: "the message about two fingers",
      comes: async () => {
        await touch("touchStart", thumb);
        await touch("touchStart", thumb, pressed);
        await said.waitFor();
        await touch("touchEnd");
      },
      // The same place of the screen is the same button, without a look.
      goes: async () => {
        await touch("touchStart", pressed);
        await moves(true);
        expect(await said.count()).toBe(0);
        await touch("touchEnd");
        await moves(false);
      },
    };
    await expectStill(page, ["Joint 1 plus, while held", "Joint 7 minus, while held"], question, twoFingers, await slowRobot(fixture, page, "toAndFro"), await otherPerson(fixture, page));
  });

  it("stops when the finger leaves for a call: the page is hidden", async () => {
    await prepare("joints");
    await hold("Joint 1 minus, while held");
    await moves(true);
    await page.evaluate(() => {
      Object.defineProperty(document, "hidden", { configurable: true, get: () => true });
      document.dispatchEvent(new Event("visibilitychange"));
    });
    await moves(false);
    await page.getByText("You have LOST the controls").waitFor();
  });

  it("gives way to a hand while a finger holds the button, and the pose is saved without typing", async () => {
    await prepare("hand");
    const lead = button("Lead the arm by hand, while held");
    await lead.waitFor();
    await looksGood("pendant-hand", "hand");
    const lift = await hold("Lead the arm by hand, while held");
    await fixture.send("POST", "/cell/person", { act: "grab", hand: "right", body: "link_7", stiffness: 500, limit: 60, keep: 10 });
    await fixture.send("POST", "/cell/person", { act: "drag", hand: "right", by: [0, 0.1, 0], speed: 0.1 });
    await moves(true);
    await page.waitForTimeout(600);
    await lift();
    await moves(false);
    await button("Save pose").tap();
    await page.getByText("Saved as pose1.").waitFor();
    await button("By hand").waitFor();
  });

  it("goes to a saved pose while a finger holds its button, and stays where it is let go", async () => {
    await prepare("poses");
    const go = "Go to pose1, while held";
    if ((await button(go).count()) === 0) {
      await button("Save pose").tap();
      await button(go).waitFor();
    }
    await page.getByRole("button", { name: "Joints" }).tap();
    const away = await hold("Joint 1 minus, while held");
    await moves(true);
    await page.waitForTimeout(1500);
    await away();
    await moves(false);
    await page.getByRole("button", { name: "Poses" }).tap();
    await looksGood("pendant-poses", "poses");
    const lift = await hold(go);
    await moves(true);
    await lift();
    await moves(false);
    const arrive = await hold(go);
    await moves(true);
    await moves(false);
    await arrive();
    const { pose } = ((await fixture.send("POST", "/services/db/calls", { operation: "get", kwargs: { key: "pose_pose1" } })) as Answer).result;
    const now = ((await fixture.send("POST", "/services/robot/calls", { operation: "state" })) as Answer).result.pose;
    now.position.forEach((at, i) => expect(at).toBeCloseTo(pose.position[i] ?? Number.NaN, 3));
    await button("Remove pose1").tap();
    await page.getByRole("button", { name: "Remove pose1", exact: true }).last().tap();
    await button(go).waitFor({ state: "detached" });
  });

  it("opens and closes the gripper", async () => {
    await prepare("joints");
    const gripper = page.getByRole("group", { name: "Gripper gripper" });
    await gripper.getByRole("button", { name: "Close" }).tap();
    await gripper.getByRole("status").filter({ hasText: /met|part/ }).waitFor();
    await gripper.getByRole("button", { name: "Open" }).tap();
    await page.getByText("Open.", { exact: true }).waitFor();
  });

  it("starts a task, says what it does, pauses it and ends it", async () => {
    await open("#run");
    if ((await mode()) === "programming") {
      await page.getByRole("button", { name: "Take the controls" }).tap();
      await button("Execution").tap();
      await page.getByRole("button", { name: "Give back" }).tap();
    }
    await button("Start toAndFro").tap();
    const run = page.getByRole("region", { name: "Run of toAndFro" });
    await run.getByText("Turn left").or(run.getByText("Turn right")).waitFor();
    await moves(true);
    await looksGood("pendant-run");
    await run.getByRole("button", { name: "Pause" }).tap();
    await run.getByText("Paused", { exact: true }).waitFor();
    await run.getByRole("button", { name: "Go on" }).tap();
    await run.getByText("Running", { exact: true }).waitFor();
    await run.getByRole("button", { name: "End the task" }).tap();
    await run.getByText("Stopped", { exact: true }).waitFor();
    await moves(false);
    await run.getByRole("button", { name: "Start again" }).tap();
    await moves(true);
    await page.getByRole("button", { name: "Take the controls" }).tap();
    const speed = page.getByRole("slider", { name: "Robot speed" });
    await speed.fill("0");
    await moves(false);
    await page.getByText("it waits on its way").waitFor();
    await speed.fill("1");
    await moves(true);
  });

  it.each([["move/joints", "pendant-landscape-joints"], ["move/hand", "pendant-landscape-hand"], ["run", "pendant-landscape-run"], ["show", "pendant-landscape-show"]])("lies on its side: %s", async (hash, name) => {
    await page.context().close();
    page = await (await fixture.openContext({ ...devices["Pixel 7 landscape"] })).newPage();
    await open(`#${hash}`);
    await looksGood(name);
  });

  it("opens without a server, once it was there, and says so", async () => {
    await open("#show");
    await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
    fixture.allowError(/ERR_INTERNET_DISCONNECTED/);
    await page.context().setOffline(true);
    await page.reload();
    await page.getByRole("heading", { name: "phone1" }).waitFor();
    await page.context().setOffline(false);
    await page.getByRole("status", { name: "Connection" }).filter({ hasText: "Connected" }).waitFor();
  });

  it("is the display of its place", async () => {
    await page.goto(`${fixture.url}/display/?name=phone1&place=gripper`);
    await page.getByRole("status", { name: "Connection" }).filter({ hasText: "Connected" }).waitFor();
    await fixture.send("PUT", "/documents/there", { rcm: 1, name: "there", root: { state: "Root", entry: "svc.display.show_progress('Half of it', 0.5, display='@gripper')" } });
    const { id } = (await fixture.send("POST", "/cores", { document: "there" })) as { readonly id: string };
    await fixture.send("POST", `/cores/${id}/start`);
    await page.getByText("Half of it").first().waitFor();
    expect(await page.getByRole("progressbar").getAttribute("value")).toBe("0.5");
    await looksGood("pendant-progress");
  });

  it("loses the server: nobody overlooks it, and nothing can be pressed", async () => {
    await prepare("joints");
    fixture.allowError(/ERR_INTERNET_DISCONNECTED/);
    await page.context().setOffline(true);
    await page.getByRole("alert", { name: "No connection" }).waitFor();
    await fixture.screenshot("pendant-lost", page);
    expect(await page.locator("main").getAttribute("inert")).not.toBeNull();
    await page.context().setOffline(false);
    await page.getByRole("status", { name: "Connection" }).filter({ hasText: "Connected" }).waitFor();
  });
});
