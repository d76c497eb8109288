// Before something moves: what starts a run asks, and the cell is put back to how it was at the start.
import { findings } from "./axe";
import { openFixture, settled, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
  fixture.page.setDefaultTimeout(kPatience);
});
afterAll(() => fixture.close());

const status = () => fixture.page.getByRole("status", { name: "Run status" }).locator("strong").innerText();
const question = () => fixture.page.getByRole("alertdialog", { name: "Before it moves" });
const press = (key: string) => fixture.page.keyboard.press(key);
/** What is pressed then answers the question. */
const isAsked = () => expect.poll(() => question().evaluate((dialog) => dialog.contains(document.activeElement)), kSoon).toBe(true);
/** The id of the run that the page watches. */
const watched = () => fixture.page.getByRole("combobox", { name: "Watched run" }).inputValue();
const make = async (document: string) => ((await fixture.send("POST", "/cores", { document })) as { readonly id: string }).id;

/** Moves the tool up by 2 cm, stores a value, and is over. */
const lifting = {
  state: "Root",
  first: "Store",
  children: [
    { state: "Store", entry: 'svc.db.add("lifted", True)', ports: [{ name: "stored", when: "svc.db.add.result", to: "Lift" }] },
    { state: "Lift", entry: 'svc.robot.move({"offset": [0, 0, 0.02]})', ports: [{ name: "done", when: "svc.robot.move.result" }] },
  ],
  ports: [{ name: "up", when: "chi.Lift.port.done" }],
};

const button = (name: string | RegExp) => fixture.page.getByRole("toolbar", { name: "Run" }).getByRole("button", { name, exact: true });

describe("what starts a run", () => {
  it("asks before the robot moves, if it is a card, a button or the key of a step: Esc starts nothing", async () => {
    const { page } = fixture;
    await fixture.send("PUT", "/documents/lifting", { rcm: 1, name: "lifting", root: lifting });
    await page.goto(`${fixture.url}/pro/`);
    await page.getByRole("listitem", { name: "lifting" }).getByRole("button", { name: "Start" }).click();
    const refuse = async (asked: string) => {
      await expect.poll(() => question().innerText()).toContain(`This moves robot. ${asked}?`);
      await isAsked();
      await press("Escape");
      await question().waitFor({ state: "detached" });
    };
    await refuse("Start");
    await settled(page);
    await button("Start").click();
    await refuse("Start");
    await button("Macro step").click();
    await refuse("Make a macro step");
    await press("F4");
    await refuse("Make a micro step");
    // It starts nothing.
    await press("F6");
    await expect.poll(status, kSoon).toBe("Ready, paused before its start");
    expect(await question().count()).toBe(0);
  });

  it("does, once a person has said so, what was asked for, and a step of a run that has begun is not asked about", async () => {
    const { page } = fixture;
    await press("F4");
    await isAsked();
    await press("Enter");
    await expect.poll(status, kSoon).toContain("Paused");
    for (const said of ["Paused: the task takes no more inputs", "Stop: the run ends, and its services are told to be safe: a robot brakes and stands."])
      await expect.poll(() => page.getByRole("complementary", { name: "Properties" }).innerText(), kSoon).toContain(said);
    await press("Shift+F4");
    await expect.poll(() => page.getByRole("status", { name: "Run status" }).innerText(), kSoon).toMatch(/step [1-9]/);
    expect(await question().count()).toBe(0);
    await press("F8");
    await expect.poll(status, kSoon).toBe("Stopped");
    await page.evaluate(() => sessionStorage.clear());
  });
});

describe("a key that starts a run", () => {
  it("asks before the robot moves; Esc starts nothing, Enter starts", async () => {
    const { page } = fixture;
    await page.goto(`${fixture.url}/pro/?run=${await make("lifting")}`);
    await settled(page);
    await press("F5");
    await isAsked();
    expect(await question().innerText()).toContain("This moves robot. Start?");
    await press("F5");
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("start-ask");
    await press("Escape");
    await question().waitFor({ state: "detached" });
    expect(await status()).toBe("Ready");
    await press("F5");
    await isAsked();
    await press("Enter");
    await expect.poll(status, kSoon).toBe("Ended: up");
  });

  it("asks once for a document: another run of it starts at once, also by a page that is loaded anew", async () => {
    const { page } = fixture;
    const before = await watched();
    await press("F5");
    await expect.poll(watched, kSoon).not.toBe(before);
    await expect.poll(status, kSoon).toBe("Ended: up");
    await page.goto(`${fixture.url}/pro/?run=${await make("lifting")}`);
    await settled(page);
    await press("F5");
    await expect.poll(status, kSoon).toBe("Ended: up");
    expect(await question().count()).toBe(0);
  });

  it("asks each time if a person wants that, and not for a task that moves nothing", async () => {
    const { page } = fixture;
    await page.evaluate(() => sessionStorage.clear());
    await press("F5");
    await question().getByRole("checkbox", { name: /^Do not ask again/ }).uncheck();
    const before = await watched();
    await question().getByRole("button", { name: /^Run again/ }).click();
    await expect.poll(watched, kSoon).not.toBe(before);
    await expect.poll(status, kSoon).toBe("Ended: up");
    await press("F5");
    await isAsked();
    await press("Escape");
    await fixture.send("PUT", "/documents/resting", { rcm: 1, name: "resting", root: { state: "Root", entry: "svc.timer.start(0.05)", ports: [{ name: "rested", when: "svc.timer.start.result" }] } });
    await page.goto(`${fixture.url}/pro/?run=${await make("resting")}`);
    await settled(page);
    await press("F5");
    await expect.poll(status, kSoon).toBe("Ended: rested");
  });

  it("does nothing below a dialog, also while the focus is not in it", async () => {
    const { page } = fixture;
    await page.goto(`${fixture.url}/pro/?run=${await make("resting")}`);
    await settled(page);
    await press("F1");
    const help = page.getByRole("dialog", { name: "Help" });
    await help.waitFor();
    await page.evaluate(() => document.activeElement instanceof HTMLElement && document.activeElement.blur());
    await press("F5");
    await page.waitForTimeout(500);
    expect(await status()).toBe("Ready");
    await press("Escape");
    await help.waitFor({ state: "detached" });
    await settled(page);
    await press("F5");
    await expect.poll(status, kSoon).toBe("Ended: rested");
  });
});

describe("what lets a task go on by other ways", () => {
  it("asks by F6 as well, which resumes in step mode", async () => {
    const { page } = fixture;
    await page.evaluate(() => sessionStorage.clear());
    const id = await make("lifting");
    await fixture.send("POST", `/cores/${id}/pause`);
    await fixture.send("POST", `/cores/${id}/start`);
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await expect.poll(status, kSoon).toBe("Paused");
    await settled(page);
    await press("F6");
    await expect.poll(() => question().innerText(), kSoon).toContain("This moves robot. Resume?");
    await isAsked();
    await press("Escape");
    await question().waitFor({ state: "detached" });
    expect(await status()).toBe("Paused");
    await press("F6");
    await isAsked();
    await press("Enter");
    await expect.poll(status, kSoon).toBe("Ended: up");
    await page.evaluate(() => sessionStorage.clear());
  });

  it("asks once a run is made with arguments and started at once, before anything moves", async () => {
    const { page } = fixture;
    await fixture.send("PUT", "/documents/lifting_as", { rcm: 1, name: "lifting_as", root: { ...lifting, parameters: [{ name: "note", type: "string", value: "" }] } });
    await page.goto(`${fixture.url}/pro/`);
    await page.getByRole("combobox", { name: "Document" }).selectOption("lifting_as");
    await page.getByRole("button", { name: "Arguments…" }).click();
    const form = page.getByRole("dialog", { name: "Arguments of lifting_as" });
    await form.getByRole("button", { name: "Load and start" }).click();
    await expect.poll(() => question().innerText(), kSoon).toContain("This moves robot. Start?");
    await expect.poll(() => form.count(), kSoon).toBe(0);
    const core = (await fixture.send("GET", `/cores/${await watched()}`)) as { readonly status: string; readonly document: string };
    expect([core.document, core.status]).toEqual(["lifting_as", "ready"]);
    await expect.poll(() => page.evaluate(() => document.activeElement?.textContent), kSoon).toContain("Start");
    await press("Enter");
    await expect.poll(status, kSoon).toBe("Ended: up");
  });
});

describe("the reset of the demo", () => {
  const reset = () => fixture.page.getByRole("group", { name: "Reset the cell?" });
  const absent = async () => ((await fixture.send("GET", "/cell/person")) as { readonly absent: readonly string[] }).absent;

  it("is refused while a run is not over, which it names", async () => {
    const { page } = fixture;
    const id = await make("lifting");
    await fixture.send("POST", `/cores/${id}/pause`);
    await fixture.send("POST", `/cores/${id}/start`);
    await page.getByRole("tab", { name: "Cell" }).click();
    await page.getByRole("button", { name: "Reset demo" }).click();
    await expect.poll(() => reset().innerText(), kSoon).toContain(`run ${id} of lifting is not over; stop it before the cell is reset`);
    await expect.poll(() => reset().getByRole("button", { name: "Reset", exact: true }).isDisabled(), kSoon).toBe(true);
    await fixture.send("POST", `/cores/${id}/stop`);
    await expect.poll(() => reset().getByRole("button", { name: "Reset", exact: true }).isDisabled(), kSoon).toBe(false);
    await fixture.screenshot("reset-ask");
    expect(await findings(page)).toEqual([]);
    await press("Escape");
    await reset().waitFor({ state: "detached" });
  });

  it("puts parts and database back once a person has said so", async () => {
    const { page } = fixture;
    await fixture.send("POST", "/cell/person", { act: "take", part: "cube_red" });
    await page.getByRole("button", { name: "Put back cube_red" }).waitFor();
    await page.getByRole("button", { name: "Reset demo" }).click();
    await reset().getByRole("button", { name: "Reset", exact: true }).click();
    await reset().waitFor({ state: "detached" });
    await expect.poll(() => absent(), kSoon).toEqual([]);
    await expect.poll(() => page.getByRole("button", { name: /^Put back/ }).count(), kSoon).toBe(0);
    await fixture.send("PUT", "/documents/reading", { rcm: 1, name: "reading", root: { state: "Root", entry: 'svc.db.get("lifted")', ports: [{ name: "there", when: "svc.db.get.result" }, { name: "gone", when: "svc.db.get.error" }] } });
    const id = await make("reading");
    await fixture.send("POST", `/cores/${id}/start`);
    await expect.poll(async () => ((await fixture.send("GET", `/cores/${id}`)) as { readonly outcome?: string }).outcome, kSoon).toBe("gone");
  });
});
