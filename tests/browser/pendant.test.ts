// The teach pendant on a phone, on the real server and cell: the arm is jogged, led by hand and sent to poses while a button is held; tasks are run.
import { devices, type Locator, type Page } from "playwright-core";
import { watchArm, type Arm } from "./arm";
import { findings } from "./axe";
import { expectStill, otherPerson, slowRobot, type Coming } from "./comes";
import { tap } from "./fingers";
import { openFixture, type Fixture } from "./fixture";
import { holding, prepareToMove } from "./prepare";
import { kPatience, kSoon } from "./patience";

/** Of what a page does that may lose the controls meanwhile. */
const kHeld = { timeout: 8000 };
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
      { state: "Wait", ports: [{ name: "next", after: "15.0", to: "Ask" }] },
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
    page.setDefaultTimeout(kPatience);
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
    await page.getByRole("region", { name: "Before you move the robot" }).waitFor();
    await prepareToMove(page, page, tap);
  }

  /** Does what needs the controls, on a page that is prepared for this part; also again, on one that is opened anew, if it has lost them meanwhile. */
  function withControls(part: string, act: () => Promise<unknown>): Promise<void> {
    const mark = page.getByText("You have the controls", { exact: true });
    const take = async () => {
      if (await mark.isVisible()) return;
      await page.goto("about:blank");
      await prepare(part);
    };
    return holding(take, mark, act);
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

  /** The arm moves while a finger holds the button; `act` is done meanwhile. */
  async function moving(name: string, act: () => Promise<unknown> = () => Promise.resolve()): Promise<void> {
    const lift = await hold(name);
    try {
      await expect.poll(arm.moves, kHeld).toBe(true);
      await act();
    } finally {
      await lift();
    }
  }

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
    await expect.poll(() => joint.isDisabled(), kSoon).toBe(true);
    await looksGood("pendant-before");
  });

  it("moves a joint while a finger holds the button, slowly at first, and no longer", async () => {
    await prepare("joints");
    await looksGood("pendant-joints", "joints");
    await withControls("joints", () => moving("Joint 1 plus, while held", () => fixture.screenshot("pendant-held", page)));
    await moves(false);
  });

  it("moves the tool along its own axes", async () => {
    await prepare("tool");
    await looksGood("pendant-tool", "tool");
    await withControls("tool", async () => {
      await tap(button("Axes of the tool"));
      await moving("Back off, tool along Z minus, while held");
    });
    await moves(false);
  });

  it("moves nothing by a second finger and says so, and stops what the first one moves", async () => {
    await prepare("joints");
    await withControls("joints", pressWithTwo);
  });

  async function pressWithTwo(): Promise<void> {
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
    try {
      await touch("touchStart", thumb);
      await touch("touchStart", thumb, await at(first));
      await said.waitFor(kHeld);
      await fixture.screenshot("pendant-two-fingers", page);
      await page.waitForTimeout(500);
      expect(arm.moves()).toBe(false);
      await touch("touchEnd");
      const pressed = await at(first);
      // Not on a button, too.
      for (const other of [second, thumb]) {
        await touch("touchStart", pressed);
        await expect.poll(arm.moves, kHeld).toBe(true);
        expect(await said.count()).toBe(0);
        await touch("touchStart", pressed, other);
        await said.waitFor(kHeld);
        await moves(false);
        await touch("touchEnd");
      }
    } catch (error) {
      await touch("touchEnd");
      throw error;
    }
  }

  it.each([
    ["upright", devices["Pixel 7"]],
    ["small", { ...devices["Pixel 7"], viewport: { width: 360, height: 640 } }],
    ["on its side", devices["Pixel 7 landscape"]],
  ])("leaves the buttons that move the arm where they are, whatever comes by itself: %s", async (name, device) => {
    await page.context().close();
    page = await (await fixture.openContext({ ...device })).newPage();
    page.setDefaultTimeout(kPatience);
    // A page that is opened may take so long that this one loses the controls.
    const [slow, person] = [await slowRobot(fixture, page, "toAndFro"), await otherPerson(fixture, page)];
    await prepare("joints");
    const views = page.getByRole("navigation", { name: "Views of phone1" });
    await tap(views.getByRole("link", { name: "Run" }));
    await tap(button("Start asksLater"));
    await page.getByRole("region", { name: "Run of asksLater" }).first().waitFor();
    await tap(views.getByRole("link", { name: "Move" }));
    const first = button("Joint 1 plus, while held");
    await first.scrollIntoViewIfNeeded();
    const asks = page.getByRole("region", { name: "A task asks" });
    expect(await asks.count(), "it has not asked yet").toBe(0);
    const question: Coming = {
      what: "a question",
      comes: () => asks.waitFor({ timeout: 60_000 }),
      goes: async () => {
        await fixture.screenshot(`pendant-still-${name.replaceAll(" ", "-")}`, page);
        const other = await (await fixture.openContext({ ...devices["Pixel 7"] })).newPage();
        await other.goto(`${fixture.url}/display/?name=phone1#show`);
        await tap(other.getByRole("button", { name: "Yes", exact: true }));
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
    await expectStill(page, ["Joint 1 plus, while held", "Joint 7 minus, while held"], () => prepareToMove(page, page, tap), question, twoFingers, slow, person);
  });

  it("stops when the finger leaves for a call: the page is hidden", async () => {
    await prepare("joints");
    const hide = () =>
      page.evaluate(() => {
        Object.defineProperty(document, "hidden", { configurable: true, get: () => true });
        document.dispatchEvent(new Event("visibilitychange"));
      });
    await withControls("joints", () =>
      moving("Joint 1 minus, while held", async () => {
        await hide();
        await moves(false);
      }),
    );
    await page.getByText("You have LOST the controls").waitFor();
  });

  it("gives way to a hand while a finger holds the button, and the pose is saved without typing", async () => {
    await prepare("hand");
    const lead = button("Lead the arm by hand, while held");
    await lead.waitFor();
    await looksGood("pendant-hand", "hand");
    await withControls("hand", async () => {
      const lift = await hold("Lead the arm by hand, while held");
      try {
        await fixture.send("POST", "/cell/person", { act: "grab", hand: "right", body: "link_7", stiffness: 500, limit: 60, keep: 10 });
        await fixture.send("POST", "/cell/person", { act: "drag", hand: "right", by: [0, 0.1, 0], speed: 0.1 });
        await expect.poll(arm.moves, kHeld).toBe(true);
      } catch (error) {
        await fixture.send("POST", "/cell/person", { act: "release", hand: "right" });
        await lift();
        throw error;
      }
      await page.waitForTimeout(600);
      await lift();
    });
    await moves(false);
    await tap(button("Save pose"));
    await page.getByText("Saved as pose1.").waitFor();
    await button("By hand").waitFor();
  });

  it("goes to a saved pose while a finger holds its button, and stays where it is let go", async () => {
    await prepare("poses");
    const go = "Go to pose1, while held";
    if ((await button(go).count()) === 0) {
      await tap(button("Save pose"));
      await button(go).waitFor();
    }
    await withControls("poses", async () => {
      await tap(page.getByRole("button", { name: "Joints" }));
      await moving("Joint 1 minus, while held", () => page.waitForTimeout(1500));
    });
    await moves(false);
    await tap(page.getByRole("button", { name: "Poses" }));
    await looksGood("pendant-poses", "poses");
    await withControls("poses", () => moving(go));
    await moves(false);
    await withControls("poses", async () => {
      await moving(go, () => moves(false));
      const { pose } = ((await fixture.send("POST", "/services/db/calls", { operation: "get", kwargs: { key: "pose_pose1" } })) as Answer).result;
      const now = ((await fixture.send("POST", "/services/robot/calls", { operation: "state" })) as Answer).result.pose;
      now.position.forEach((at, i) => expect(at).toBeCloseTo(pose.position[i] ?? Number.NaN, 3));
    });
    await tap(button("Remove pose1"));
    await tap(page.getByRole("button", { name: "Remove pose1", exact: true }).last());
    await button(go).waitFor({ state: "detached" });
  });

  it("opens and closes the gripper", async () => {
    await prepare("joints");
    const gripper = page.getByRole("group", { name: "Gripper gripper" });
    await withControls("joints", async () => {
      await tap(gripper.getByRole("button", { name: "Close" }), kHeld);
      await gripper.getByRole("status").filter({ hasText: /met|part/ }).waitFor(kHeld);
    });
    await withControls("joints", async () => {
      await tap(gripper.getByRole("button", { name: "Open" }), kHeld);
      await page.getByText("Open.", { exact: true }).waitFor(kHeld);
    });
  });

  it("starts a task, says what it does, pauses it and ends it", async () => {
    await open("#run");
    const mark = page.getByText("You have the controls", { exact: true });
    const take = async () => {
      if (await mark.isVisible()) return;
      await tap(page.getByRole("button", { name: "Take the controls" }));
      await mark.waitFor();
    };
    if ((await mode()) === "programming") {
      await holding(take, mark, async () => {
        await tap(button("Execution"), kHeld);
        await expect.poll(mode, kHeld).toBe("execution");
      });
      await holding(take, mark, () => tap(page.getByRole("button", { name: "Give back" }), kHeld));
    }
    await tap(button("Start toAndFro"));
    const run = page.getByRole("region", { name: "Run of toAndFro" });
    await run.getByText("Turn left").or(run.getByText("Turn right")).waitFor();
    await moves(true);
    await looksGood("pendant-run");
    await tap(run.getByRole("button", { name: "Pause" }));
    await run.getByText("Paused", { exact: true }).waitFor();
    await tap(run.getByRole("button", { name: "Go on" }));
    await run.getByText("Running", { exact: true }).waitFor();
    await tap(run.getByRole("button", { name: "End the task" }));
    await run.getByText("Stopped", { exact: true }).waitFor();
    await moves(false);
    await tap(run.getByRole("button", { name: "Start again" }));
    await moves(true);
    const speed = page.getByRole("slider", { name: "Robot speed" });
    await holding(take, mark, async () => {
      await speed.fill("0", kHeld);
      await expect.poll(arm.moves, kHeld).toBe(false);
      await page.getByText("it waits on its way").waitFor(kHeld);
      await speed.fill("1", kHeld);
      await expect.poll(arm.moves, kHeld).toBe(true);
    });
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
    await expect.poll(() => page.locator("main").getAttribute("inert"), kSoon).not.toBeNull();
    await page.context().setOffline(false);
    await page.getByRole("status", { name: "Connection" }).filter({ hasText: "Connected" }).waitFor();
  });
});
