// The controls of the cell on the real server: taken, seen by everybody, asked for, given back, lost; the modes, what is moved by hand, and edits that are confirmed.
import { devices, type Locator, type Page } from "playwright-core";
import { watchArm, type Arm } from "./arm";
import { findings } from "./axe";
import { expectStill, otherPerson, secondFinger, slowRobot } from "./comes";
import { tap } from "./fingers";
import { openFixture, settled, type Fixture } from "./fixture";
import { holding } from "./prepare";
import { kPatience, kSoon } from "./patience";

/** Of what a page does that may lose the controls meanwhile. */
const kHeld = { timeout: 8000 };

const bar = (page: Page) => page.getByRole("region", { name: "Controls of the cell" });
const panel = (page: Page) => page.getByRole("region", { name: "Manual control" });
const take = (page: Page) => bar(page).or(panel(page)).getByRole("button", { name: "Take the controls" }).first();
const giveBack = (page: Page) => bar(page).getByRole("button", { name: "Give back" });
const lost = (page: Page) => page.getByRole("alert").filter({ hasText: "You have LOST the controls" });
const modeButton = (page: Page) => page.getByRole("button", { name: / mode$/ });

const move = (base: number, speed = 0.2) => `svc.robot.move({'joints': [${base}, -0.35, 0, 1.6, 0, -1.19, 0]}, speed=${speed})`;
const turn = (state: string, other: string, base: number) => ({ state, entry: move(base), ports: [{ name: "next", when: "svc.robot.move.result", to: other }, { name: "failed", when: "svc.robot.move.error" }] });
/** Moves to and fro. */
const toAndFro = { rcm: 1, name: "toAndFro", root: { state: "Root", first: "To", children: [turn("To", "Fro", 1.2), turn("Fro", "To", 0)] } };

interface Control {
  readonly mode: string;
  readonly holder: { readonly number: number; readonly by: string } | null;
  readonly request: { readonly id: number } | null;
  readonly leases: readonly { readonly service: string; readonly core: string }[];
}

describe("the controls of the cell", () => {
  let fixture: Fixture;
  let page: Page;
  let arm: Arm;
  beforeAll(async () => {
    fixture = await openFixture();
    ({ page } = fixture);
    page.setDefaultTimeout(kPatience);
    arm = watchArm(fixture.url);
    await fixture.send("PUT", "/documents/toAndFro", toAndFro);
    await page.setViewportSize({ width: 1366, height: 768 });
    await open(page);
  });
  afterAll(async () => {
    arm.close();
    await fixture.close();
  });
  // A test that has failed leaves nobody at the controls, and execution mode.
  afterEach(async () => {
    await fixture.send("POST", "/stop");
    await fixture.send("POST", "/stop/reset");
    if ((await control()).mode === "programming") {
      await open(page);
      await hold(page);
      await setMode(page, "Execution");
    }
    for (const context of page.context().browser()?.contexts() ?? [])
      for (const each of context.pages())
        if (await giveBack(each).isVisible()) await giveBack(each).click(kHeld).catch(() => undefined);
  });

  const control = async () => (await fixture.send("GET", "/control")) as Control;
  const statusOf = async (id: string) => (await fixture.send("GET", `/cores/${id}`)) as { readonly status: string; readonly paused: boolean };
  const holder = async () => (await control()).holder;
  async function open(on: Page, query = "below=manual"): Promise<void> {
    await on.goto(`${fixture.url}/pro/?${query}`);
    await on.getByText("Connected", { exact: true }).waitFor();
    await panel(on).waitFor();
    // What draws it may keep a page without a GPU from its signs of life.
    const close = on.getByRole("button", { name: "Close the cell view" });
    if (await close.isVisible()) await close.click();
  }
  /** Of a page that has the controls: to make one, or to look for findings, takes the page so long that it may lose them. */
  async function heldScreenshot(name: string, on = page): Promise<void> {
    for (let tries = 0; tries < 5; tries++) {
      await hold(on);
      await fixture.screenshot(name, on);
      if ((await held(on).count()) > 0) return;
    }
  }
  async function openSecond(): Promise<Page> {
    const second = await (await fixture.openContext({ viewport: { width: 1366, height: 768 } })).newPage();
    second.setDefaultTimeout(kPatience);
    await open(second);
    return second;
  }
  const held = (on: Page) => panel(on).getByRole("heading", { name: "You have the controls" });
  async function hold(on: Page): Promise<void> {
    if ((await held(on).count()) > 0) return;
    const read = on.getByRole("button", { name: "I have read this" });
    // It goes by itself once the controls are taken.
    if (await read.isVisible()) await read.click({ timeout: 5000 }).catch(() => undefined);
    await take(on).click();
    await held(on).waitFor();
  }
  /** Does what needs the controls, also again: a machine that has much to do may keep the page from its signs of life. */
  const withControls = (on: Page, act: () => Promise<unknown>) => holding(() => hold(on), held(on), act);
  const setMode = (on: Page, name: "Execution" | "Programming") =>
    withControls(on, async () => {
      await panel(on).getByRole("button", { name, exact: true }).click(kHeld);
      await on.getByRole("button", { name: `${name} mode` }).waitFor(kHeld);
    });
  /** Shows a run that moves to and fro, when it is started. */
  async function load(on: Page): Promise<string> {
    const { id } = (await fixture.send("POST", "/cores", { document: "toAndFro" })) as { readonly id: string };
    await open(on, `below=manual&run=${id}`);
    await settled(on);
    return id;
  }

  /** Lets that run go on, which the page asks about the first time; again if it was paused meanwhile, as the page has lost the controls. */
  function goOn(answer: RegExp, before: (question: Locator) => Promise<unknown> = () => Promise.resolve()): () => Promise<void> {
    let isAnswered = false;
    return async () => {
      await page.getByRole("toolbar", { name: "Run" }).getByRole("button", { name: /^(Start|Resume)$/ }).click(kHeld);
      if (!isAnswered) {
        const question = page.getByRole("alertdialog", { name: "Before it moves" });
        await before(question);
        await question.getByRole("button", { name: answer }).click(kHeld);
        isAnswered = true;
      }
      await expect.poll(arm.moves, kHeld).toBe(true);
    };
  }

  it("are nobody's until somebody takes them; the mode is said in a word", async () => {
    await page.waitForTimeout(500);
    expect(await holder()).toBeNull();
    await expect.poll(() => modeButton(page).innerText(), kSoon).toBe("Execution");
    expect(await bar(page).count()).toBe(0);
    await expect.poll(() => panel(page).innerText(), kSoon).toContain("Nothing is moved by hand: take the controls first.");
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("control-free-1366");
  });

  it("are taken by a button, and another page sees that and is refused in advance", async () => {
    const second = await openSecond();
    await withControls(page, async () => {
      expect((await holder())?.by).toBe("somebody at 127.0.0.1");
      await page.waitForTimeout(1500);
      expect(await holder(), "they stay").not.toBeNull();
    });
    await expect.poll(async () => {
      await hold(page);
      return bar(second).getByText("somebody at 127.0.0.1 has the controls").isVisible();
    }, kSoon).toBe(true);
    const { id } = (await fixture.send("POST", "/cores", { document: "toAndFro" })) as { readonly id: string };
    await second.getByRole("combobox", { name: "Watched run" }).selectOption(id);
    const button = second.getByRole("button", { name: "Start", exact: true });
    await expect.poll(async () => {
      await hold(page);
      return [await button.getAttribute("title"), await button.isDisabled(), await panel(second).getByRole("button", { name: "Programming", exact: true }).isDisabled()];
    }, kSoon).toEqual([expect.stringContaining("somebody at 127.0.0.1 has the controls"), true, true]);
    for (const [width, height] of [[1366, 768], [2560, 1440], [390, 844]] as const) {
      await second.setViewportSize({ width, height });
      await second.waitForTimeout(400);
      await hold(page);
      await fixture.screenshot(`control-other-${width}`, second);
    }
    await hold(page);
    expect(await findings(second)).toEqual([]);
    await withControls(page, async () => {
      await giveBack(page).click(kHeld);
      await expect.poll(holder, kSoon).toBeNull();
      expect(await lost(page).count(), "who gives them back has not lost them").toBe(0);
    });
    await second.context().close();
  });

  it("are asked for by another page: refused by one at the cell, then allowed, and who had them is told at once", async () => {
    const second = await openSecond();
    const request = page.getByRole("group", { name: "Request for the controls" });
    /** Asks once more, if the page has lost the controls before it has answered: then there was nobody to be asked. */
    const asked = (answer: () => Promise<unknown>) =>
      holding(
        async () => {
          for (const left of ["Give back", "Ask no more", "I have read this"]) {
            const button = second.getByRole("button", { name: left }).first();
            if (await button.isVisible()) await button.click(kHeld).catch(() => undefined);
          }
          await hold(page);
        },
        held(page),
        async () => {
          await panel(second).getByRole("button", { name: "Ask to take over" }).click(kHeld);
          await request.waitFor(kHeld);
          await answer();
        },
      );
    await asked(async () => {
      const first = await holder();
      await expect.poll(() => request.innerText(), kHeld).toContain("You lose them if this is allowed");
      expect(await page.evaluate(() => document.activeElement?.textContent), "the focus stays").not.toMatch(/Allow|Refuse/);
      await request.getByRole("button", { name: "Refuse" }).press("Enter", kHeld);
      await second.getByRole("alert").filter({ hasText: "You do not get the controls" }).waitFor(kHeld);
      expect((await holder())?.number).toBe(first?.number);
    });
    await second.getByRole("button", { name: "I have read this" }).click();

    await asked(async () => {
      await fixture.screenshot("control-asking-1366", second);
      await request.getByRole("button", { name: "Allow" }).click(kHeld);
      await held(second).waitFor(kHeld);
      await lost(page).waitFor(kHeld);
    });
    await expect.poll(() => bar(page).innerText(), kSoon).toContain("What you moved by hand has stopped");
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("control-lost-1366");
    await heldScreenshot("control-held-1366", second);
    await page.getByRole("button", { name: "I have read this" }).click();
    await lost(page).waitFor({ state: "detached" });
    await second.context().close();
    await expect.poll(holder, { ...kSoon, message: "a page that is closed has them no more" }).toBeNull();
  });

  it("are asked about on a display, too, and may be taken there", async () => {
    const phone = await (await fixture.openContext({ ...devices["Pixel 7"] })).newPage();
    phone.setDefaultTimeout(kPatience);
    await phone.goto(`${fixture.url}/display/?name=phone`);
    await bar(phone).getByText("Execution mode").waitFor();
    await fixture.screenshot("control-display", phone);
    const mark = bar(phone).getByText("You have the controls", { exact: true });
    const take = async () => {
      const read = page.getByRole("button", { name: "I have read this" });
      if (await read.isVisible()) await read.click(kHeld).catch(() => undefined);
      if (await mark.isVisible()) return;
      await tap(bar(phone).getByRole("button", { name: "Take the controls" }));
      await mark.waitFor();
    };
    await holding(take, mark, async () => {
      await panel(page).getByRole("button", { name: "Ask to take over" }).click(kHeld);
      await phone.getByRole("group", { name: "Request for the controls" }).waitFor(kHeld);
      await tap(phone.getByRole("button", { name: "Allow" }), kHeld);
      await held(page).waitFor(kHeld);
      await lost(phone).waitFor(kHeld);
    });
    expect(await findings(phone)).toEqual([]);
    await fixture.screenshot("control-display-lost", phone);
    await phone.context().close();
  });

  it("are given back by a page that is hidden, frozen or left, and not taken again", async () => {
    const second = await openSecond();
    for (const [event, why] of [["visibilitychange", "this page was hidden"], ["freeze", "this page was frozen"], ["pagehide", "this page was left"]] as const) {
      await withControls(second, async () => {
        // Without a screen, a browser hides no page.
        await second.evaluate((event) => {
          Object.defineProperty(document, "hidden", { configurable: true, get: () => event === "visibilitychange" });
          (event === "pagehide" ? window : document).dispatchEvent(new Event(event));
        }, event);
        await expect.poll(holder, kSoon).toBeNull();
        await expect.poll(() => lost(second).innerText(), kHeld).toContain(why);
      });
      await second.waitForTimeout(500);
      expect(await holder()).toBeNull();
    }
    await second.reload();
    await second.getByText("Connected", { exact: true }).waitFor();
    await second.waitForTimeout(500);
    expect(await holder(), "a page that is loaded anew takes nothing").toBeNull();
    await hold(second);
    await second.goto("about:blank");
    await expect.poll(holder, kSoon).toBeNull();
    await second.context().close();
  });

  it("are lost by a page whose device sleeps, which says so when it wakes up", async () => {
    const second = await openSecond();
    const devtools = await second.context().newCDPSession(second);
    await devtools.send("Debugger.enable");
    await hold(second);
    await devtools.send("Debugger.pause");
    await expect.poll(holder, kSoon).toBeNull();
    await devtools.send("Debugger.resume");
    await lost(second).waitFor();
    expect(await holder()).toBeNull();
    await second.context().close();
  });

  it("are lost by a page that stands still, which says so itself", async () => {
    await hold(page);
    await page.evaluate(() => {
      for (const end = performance.now() + 700; performance.now() < end; );
    });
    await lost(page).waitFor();
    expect(await holder()).toBeNull();
    await expect.poll(() => lost(page).innerText(), kSoon).toMatch(/this page stood still for \d+ ms|you have not the controls/);
  });

  it("let who has them set the mode, by keyboard alone; in programming mode nothing begins without them", async () => {
    const id = await load(page);
    const mode = async () => (await control()).mode;
    const takeByKey = async () => {
      await panel(page).getByRole("button", { name: "Take the controls" }).focus();
      await page.keyboard.press("Enter");
      await held(page).waitFor();
    };
    await holding(takeByKey, held(page), async () => {
      await panel(page).getByRole("button", { name: "Programming", exact: true }).focus();
      await page.keyboard.press("Space");
      await expect.poll(mode, kHeld).toBe("programming");
    });
    await bar(page).getByText("Programming mode, reduced speed 250 mm/s").waitFor();
    for (const [width, height] of [[1366, 768], [2560, 1440], [390, 844]] as const) {
      await page.setViewportSize({ width, height });
      await page.waitForTimeout(400);
      await heldScreenshot(`control-programming-${width}`);
    }
    await page.setViewportSize({ width: 1366, height: 768 });
    await page.emulateMedia({ colorScheme: "dark" });
    await page.waitForTimeout(500); // colours change slowly
    expect(await findings(page)).toEqual([]);
    await heldScreenshot("control-programming-dark");
    await page.emulateMedia({ colorScheme: "light" });
    await page.waitForTimeout(500);
    await withControls(page, () => giveBack(page).press("Enter", kHeld));
    const button = page.getByRole("button", { name: "Start", exact: true });
    await expect.poll(() => button.getAttribute("title"), kSoon).toContain("in programming mode, take the controls first");
    const start = goOn(/^Start/);
    await withControls(page, async () => {
      await start();
      await panel(page).getByRole("button", { name: "Execution", exact: true }).click(kHeld);
      const asks = page.getByRole("alertdialog", { name: "Before the mode changes" });
      await expect.poll(() => asks.innerText(), kHeld).toContain(`Run ${id} is paused, and what moves stops.`);
      await asks.getByRole("button", { name: "Change to execution" }).click(kHeld);
      await expect.poll(mode, kHeld).toBe("execution");
    });
    await expect.poll(async () => (await statusOf(id)).paused, kSoon).toBe(true);
    await expect.poll(arm.moves, kSoon).toBe(false);
  });

  it("are needed by a run that is supervised, which is paused without them", async () => {
    const id = await load(page);
    await hold(page);
    await page.evaluate(() => sessionStorage.clear());
    const start = goOn(/^Start/, async (question) => {
      const box = question.getByRole("checkbox", { name: /^Supervised/ });
      expect(await box.isChecked()).toBe(false);
      await box.check(kHeld);
    });
    await withControls(page, async () => {
      await start();
      await giveBack(page).click(kHeld);
    });
    await expect.poll(async () => (await statusOf(id)).paused, kSoon).toBe(true);
    await expect.poll(arm.moves, kSoon).toBe(false);
  });

  it("confirm edits of a run that moves something", async () => {
    const id = await load(page);
    await fixture.send("PUT", `/cores/${id}/live`, { live: true });
    const second = await openSecond();
    await second.getByRole("combobox", { name: "Watched run" }).selectOption(id);
    await hold(page);
    await page.evaluate(() => sessionStorage.setItem("race.moves.toAndFro", "1"));
    await page.getByRole("button", { name: "Start", exact: true }).click();
    await expect.poll(arm.moves, kSoon).toBe(true);
    const { revision } = (await fixture.send("GET", "/documents/toAndFro")) as { readonly revision: number };
    const edited = { ...toAndFro, root: { ...toAndFro.root, children: [turn("To", "Fro", 1.1), turn("Fro", "To", 0)] } };
    const answer = await fetch(`${fixture.url}/api/v1/documents/toAndFro`, { method: "PUT", body: JSON.stringify(edited), headers: { "content-type": "application/json", "if-match": `"${revision}"` } });
    expect(answer.status).toBe(200);
    const waiting = page.getByRole("status", { name: "Waiting edit" });
    const confirm = waiting.getByRole("button", { name: `Confirm revision ${revision + 1}` });
    await confirm.waitFor();
    const others = second.getByRole("button", { name: `Confirm revision ${revision + 1}` });
    await others.waitFor();
    await expect.poll(async () => {
      await hold(page);
      return [await others.isDisabled(), await others.getAttribute("title")];
    }, kSoon).toEqual([true, "somebody at 127.0.0.1 has the controls"]);
    await fixture.screenshot("control-confirm-other", second);
    expect(await findings(second)).toEqual([]);
    await heldScreenshot("control-confirm");
    await withControls(page, async () => {
      if (await confirm.isVisible()) await confirm.click(kHeld);
      await waiting.waitFor({ state: "detached", ...kHeld });
    });
    await second.context().close();
    await expect.poll(async () => ((await fixture.send("GET", `/cores/${id}`)) as { readonly revision: number }).revision, kSoon).toBe(revision + 1);
  });

  it("call for a motion while a button is held, end it at once when it is not, and call no more", async () => {
    const other = await (await fixture.openContext({ viewport: { width: 1366, height: 768 } })).newPage();
    other.setDefaultTimeout(kPatience);
    const calls: { readonly operation: string; readonly kwargs: Readonly<Record<string, unknown>> }[] = [];
    await other.routeWebSocket(/\/api\/v1\/control\/hold/, (socket) => {
      const server = socket.connectToServer();
      socket.onMessage((message) => {
        const request = JSON.parse(String(message)) as { readonly type: string; readonly operation: string; readonly kwargs: Readonly<Record<string, unknown>> };
        if (request.type === "call") calls.push({ operation: request.operation, kwargs: request.kwargs });
        server.send(message);
      });
    });
    await open(other);
    const plus = panel(other).getByRole("button", { name: "Joint 1 plus, while held" });
    await expect.poll(() => plus.getAttribute("title"), kSoon).toBe("take the controls first");
    await expect.poll(async () => {
      await hold(other);
      return [await plus.isDisabled(), await plus.getAttribute("title")];
    }, kSoon).toEqual([true, "this needs programming mode"]);
    await setMode(other, "Programming");
    expect(await findings(other)).toEqual([]);
    for (const [width, height] of [[390, 844], [2560, 1440], [1366, 768]] as const) {
      await other.setViewportSize({ width, height });
      await other.waitForTimeout(400);
      await heldScreenshot(`control-jog-${width}`, other);
    }
    /** What ends what has called for `wanted`: the last calls are that of a motion that stands, `stands`, and that of a stop. */
    const jogged = ([wanted, stands]: readonly [object, object], press: () => Promise<unknown>, letGo: () => Promise<unknown>, later = () => Promise.resolve()) =>
      withControls(other, async () => {
        calls.length = 0;
        try {
          try {
            await press();
            await expect.poll(() => calls.length, kHeld).toBeGreaterThan(3);
            expect(calls[0]).toEqual({ operation: "jog", kwargs: wanted });
          } finally {
            await letGo();
          }
          await expect.poll(() => calls.slice(-2), kHeld).toEqual([{ operation: "jog", kwargs: stands }, { operation: "stop", kwargs: {} }]);
          const { length } = calls;
          await other.waitForTimeout(300);
          expect(calls.length, "nothing comes later").toBe(length);
        } finally {
          await later();
        }
      });
    const { mouse, keyboard } = other;
    const joint = [{ joints: [expect.closeTo(0.08) as unknown, 0, 0, 0, 0, 0, 0] }, { joints: [0, 0, 0, 0, 0, 0, 0] }] as const;
    const press = async () => {
      await plus.hover(kHeld);
      await mouse.down();
    };
    await jogged(joint, press, () => mouse.up());
    const slip = async () => {
      await mouse.move(10, 10);
      await mouse.up();
    };
    await jogged(joint, press, slip);

    await panel(other).getByRole("combobox", { name: "Tool along" }).selectOption("tool");
    const tool = [{ linear: [0, 0, expect.closeTo(-0.025) as unknown], frame: "tool" }, { linear: [0, 0, 0], frame: "tool" }] as const;
    const byKey = (key: string) => async () => {
      await panel(other).getByRole("button", { name: "Tool along Z minus, while held" }).focus();
      await keyboard.down(key);
      await keyboard.down(key); // its repeat is no press
    };
    await jogged(tool, byKey("Space"), () => keyboard.up("Space"));
    await jogged(tool, byKey("Enter"), () => other.evaluate(() => window.dispatchEvent(new Event("blur"))), () => keyboard.up("Enter"));
    await setMode(other, "Execution");
    await other.context().close();
  });

  it("move the robot while a button is held, by mouse and by key, and no longer", async () => {
    await open(page);
    const plus = panel(page).getByRole("button", { name: "Joint 1 plus, while held" });
    await expect.poll(async () => {
      await hold(page);
      return [await plus.isDisabled(), await plus.getAttribute("title")];
    }, kSoon).toEqual([true, "this needs programming mode"]);
    await setMode(page, "Programming");
    await withControls(page, async () => {
      try {
        await plus.hover(kHeld);
        await page.mouse.down();
        await expect.poll(arm.moves, kHeld).toBe(true);
        await page.waitForTimeout(1000);
        expect(arm.moves()).toBe(true);
      } finally {
        await page.mouse.up();
      }
      await expect.poll(arm.moves, { timeout: 2000 }).toBe(false);
      expect((await control()).leases).toContainEqual({ service: "robot", core: expect.stringMatching(/^control\//) as unknown });
    });

    /** Held by this key, it moves until the button is let go so. */
    const moves = (key: string, letGo: () => Promise<unknown>) =>
      withControls(page, async () => {
        try {
          await panel(page).getByRole("button", { name: "Tool along Z plus, while held" }).focus();
          await page.keyboard.down(key);
          await expect.poll(arm.moves, kHeld).toBe(true);
          await letGo();
          await expect.poll(arm.moves, { timeout: 2000 }).toBe(false);
        } finally {
          await page.keyboard.up(key);
        }
      });
    await moves("Space", () => page.keyboard.up("Space"));
    await moves("Enter", () => page.evaluate(() => window.dispatchEvent(new Event("blur"))));
  });

  it("leave the buttons that move the arm where they are, whatever comes by itself", async () => {
    await open(page);
    await hold(page);
    await setMode(page, "Programming");
    const name = "Joint 1 plus, while held";
    const held = panel(page).getByRole("button", { name, exact: true });
    await held.scrollIntoViewIfNeeded();
    const coming = [secondFinger(page, held), await slowRobot(fixture, page, "toAndFro"), await otherPerson(fixture, page)];
    await expectStill(page, [name, "Tool along Z minus, while held"], () => hold(page), ...coming);
    await page.unrouteAll({ behavior: "ignoreErrors" });
  });

  it("open and close the gripper by hand", async () => {
    await open(page);
    await hold(page);
    await setMode(page, "Programming");
    const gripper = panel(page).getByRole("group", { name: "Gripper gripper" });
    await withControls(page, async () => {
      await gripper.getByRole("button", { name: "Open" }).click(kHeld);
      await gripper.getByText("Open.").waitFor(kHeld);
    });
    await withControls(page, async () => {
      await gripper.getByRole("button", { name: "Close" }).click(kHeld);
      await expect.poll(() => gripper.getByRole("status").innerText(), kHeld).not.toBe("");
    });
    await fixture.screenshot("control-gripper");
  });
});
