// Each kind of breakpoint stops the run where it says, and steps by states end where they should; on the real server, with tasks that move nothing.
import { openFixture, settled, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
  fixture.page.setDefaultTimeout(kPatience);
  await fixture.send("PUT", "/documents/kinds", kinds);
  await fixture.send("PUT", "/documents/ways", ways);
});
afterAll(() => fixture.close());
// A test that fails leaves no breakpoint to the next one.
afterEach(async () => {
  while ((await rows().count()) > 0) await rows().first().getByRole("button", { name: /^Remove/ }).click();
});

const soon = (value: () => unknown) => expect.poll(value, kSoon);
const press = (key: string) => fixture.page.keyboard.press(key);
const never = { name: "never", when: "False" };

/** In one macro step: A, then B, which counts to 2 by an action, then C, then D, which faults as it is entered. */
const kinds = {
  rcm: 1,
  root: {
    state: "Root", first: "A", ports: [never],
    children: [
      { state: "A", ports: [{ name: "done", when: "True", to: "B" }] },
      { state: "B", variables: [{ name: "n", initial: 0 }], entry: "var.n = 1", actions: [{ when: "var.n == 1", do: "var.n = 2" }], ports: [{ name: "done", when: "var.n == 2", to: "C" }] },
      { state: "C", ports: [{ name: "go", when: "True", to: "D" }] },
      { state: "D", variables: [{ name: "n", initial: 1 }], entry: "var.n = var.n / 0" },
    ],
  },
};

/** In one macro step: Begin, then A with A1 and A2, then B, then C. */
const ways = {
  rcm: 1,
  root: {
    state: "Root", first: "Begin", ports: [never],
    children: [
      { state: "Begin", ports: [{ name: "go", when: "True", to: "A" }] },
      { state: "A", first: "A1", children: [{ state: "A1", ports: [{ name: "done", when: "True", to: "A2" }] }, { state: "A2", ports: [{ name: "done", when: "True" }] }], ports: [{ name: "done", when: "chi.A2.port.done", to: "B" }] },
      { state: "B", ports: [{ name: "next", when: "True", to: "C" }] },
      { state: "C", ports: [never] },
    ],
  },
};

interface Seen {
  readonly core: { readonly status: string; readonly paused: boolean };
  readonly state: { readonly active: readonly string[]; readonly variables: Readonly<Record<string, Readonly<Record<string, unknown>>>> };
}
const seen = async (id: string) => (await fixture.send("GET", `/cores/${id}/state`)) as Seen;
const status = async (id: string) => ((await fixture.send("GET", `/cores/${id}`)) as Seen["core"]).status;
/** What the page shows as active: a step is of what it shows. */
const active = () => fixture.page.locator('[role="treeitem"][data-active="true"]').evaluateAll((all) => all.map((each) => each.getAttribute("data-path")).join(" "));
const rows = () => fixture.page.getByRole("region", { name: "Breakpoints" }).getByRole("listitem");
const reached = () => fixture.page.getByRole("status", { name: "Breakpoint" });

/** Shows a run that has not begun. */
async function make(document: string): Promise<string> {
  const { id } = (await fixture.send("POST", "/cores", { document })) as { readonly id: string };
  await fixture.page.goto(`${fixture.url}/pro/?run=${id}`);
  await settled(fixture.page);
  return id;
}

/** Chooses a kind of breakpoint in the menu of a state or port of the drawing. */
async function set(at: string, kind: string): Promise<void> {
  const { page } = fixture;
  const port = at.includes(".");
  await page.locator(`.canvas [${port ? "data-address" : "data-path"}="${at}"]`).first().click({ button: "right", position: { x: 12, y: port ? 6 : 8 } });
  await page.getByRole("menuitem", { name: /^Breakpoint when/ }).click();
  await page.getByRole("menuitem", { name: kind }).click();
  await soon(() => rows().count()).toBe(1);
}

describe("a breakpoint", () => {
  it.each([
    { at: "Root/B", kind: "an action is executed", told: "B, executed", is: "Root Root/B", n: 2 },
    { at: "Root/B", kind: "the condition becomes fulfilled", condition: "var.n == 1", told: "B, fulfilled", is: "Root Root/B", n: 1 },
    { at: "Root/B", kind: "the state is left", told: "B, left", is: "Root" },
    { at: "Root/B", kind: "the state is entered", told: "B, entered", is: "Root Root/B" },
    { at: "Root/B", kind: "the state is entered", before: true, told: "B, before: entered", is: "Root" },
    { at: "Root/C.go", kind: "the port fires", before: true, told: "C.go, before: fired", is: "Root Root/C" },
    { at: "Root/C.go", kind: "the port fires", told: "C.go, fired", is: "Root" },
    { at: "Root/D", kind: "the run faults there", told: "D, faults", is: "Root" },
  ])("stops when $kind at $at: $told", async ({ at, kind, condition, before = false, told, is, n }) => {
    const { page } = fixture;
    const id = await make("kinds");
    await set(at, kind);
    if (condition !== undefined) {
      const field = rows().getByRole("textbox", { name: "Condition" });
      await field.fill(condition);
      await field.press("Enter");
    }
    const sent = async () => ((await fixture.send("GET", `/cores/${id}`)) as { readonly breakpoints: readonly { readonly condition?: string; readonly before?: boolean }[] }).breakpoints;
    await soon(async () => (await sent()).map((each) => each.condition)).toEqual([condition]);
    if (before) {
      await rows().getByRole("button", { name: /make it before/ }).click();
      await soon(async () => (await sent()).map((each) => each.before)).toEqual([true]);
    }
    await page.getByRole("toolbar", { name: "Run" }).getByRole("button", { name: "Start", exact: true }).click();
    await soon(() => reached().innerText()).toContain(`Paused: breakpoint at ${told}`);
    const { core, state } = await seen(id);
    expect([core.status, core.paused]).toEqual(["running", true]);
    expect(state.active.join(" ")).toBe(is);
    if (n !== undefined) expect(state.variables["Root/B"]?.["n"]).toBe(n);
    await rows().getByRole("button", { name: /^Remove/ }).click();
    await soon(async () => (await sent()).length).toBe(0);
    await press("F5");
    await soon(() => status(id)).toBe("faulted");
  });
});

describe("the list of breakpoints, on the page of a run", () => {
  it("says of a condition which name the state does not have, before it is sent", async () => {
    await make("kinds");
    await set("Root/B", "the state is left");
    const field = rows().getByRole("textbox", { name: "Condition" });
    await field.fill("par.kee == 1");
    await soon(() => rows().innerText()).toContain("kee is not declared here");
    await field.fill("var.n == 1");
    await soon(() => rows().innerText()).not.toContain("not declared");
    await field.press("Escape");
  });

  it("is the same in another tab of the browser, also of who has chosen no name", async () => {
    await set("Root/B", "the state is entered");
    const other = await fixture.page.context().newPage();
    await other.goto(fixture.page.url());
    await soon(() => other.getByRole("region", { name: "Breakpoints" }).getByRole("listitem").count()).toBe(1);
    await other.close();
  });
});

describe("a step", () => {
  let id = "";

  it("into goes to what is entered next, and out of a state without any", async () => {
    id = await make("ways");
    await press("F6");
    await soon(() => fixture.page.getByRole("status", { name: "Run status" }).innerText()).toContain("paused before its start");
    await press("F4");
    await soon(active).toBe("Root Root/Begin");
    await press("F4");
    await soon(active).toBe("Root");
    await press("F11");
    await soon(active).toBe("Root Root/A Root/A/A1");
    await press("F11");
    await soon(active).toBe("Root Root/A");
  });

  it("until here ends when the selected state is entered, or the selected port fires", async () => {
    const { page } = fixture;
    await page.getByRole("treeitem", { name: "Root/B", exact: true }).getByRole("button").last().click();
    await press("Control+F10");
    await soon(active).toBe("Root Root/B");
    await page.locator('.canvas [data-address="Root/B.next"]').click();
    await press("Control+F10");
    await soon(active).toBe("Root");
    await soon(async () => (await seen(id)).core.paused).toBe(true);
    await press("F5");
    await soon(active).toBe("Root Root/C");
  });
});
