// Going back: the page shows a run as it was at earlier micro steps, and the run itself goes on. On the real server, whose digests tell moments apart.
import type { Page } from "playwright-core";
import { findings } from "./axe";
import { openFixture, settled, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
  page.setDefaultTimeout(kPatience);
  await page.setViewportSize({ width: 1366, height: 768 });
});
afterAll(() => fixture.close());

const soon = (value: () => unknown) => expect.poll(value, kSoon);

interface CoreJson {
  readonly id: string;
  readonly step: number;
  readonly micro: number;
  readonly revision: number;
}
const send = async (method: string, path: string, body?: unknown) => (await fixture.send(method, path, body)) as CoreJson;
const core = (id: string) => send("GET", `/cores/${id}`);

/** A and B are done one after the other; the barrier opens when both are. Then it waits for an hour. */
const meeting = {
  state: "Root", first: "Split", variables: [{ name: "met", initial: 0 }],
  children: [
    { barrier: "Split", to: ["A", "B"] },
    { state: "A", entry: "svc.timer.wait(0.05)", ports: [{ name: "done", when: "svc.timer.wait.result", to: "Join" }] },
    { state: "B", entry: "svc.timer.wait(0.2)", ports: [{ name: "done", when: "svc.timer.wait.result", to: "Join" }] },
    { barrier: "Join", to: ["After"] },
    { state: "After", parameters: [{ name: "seconds", value: 3600 }], entry: "svc.timer.wait(par.seconds)", ports: [{ name: "done", when: "svc.timer.wait.result" }] },
  ],
  actions: [{ when: "chi.B.port.done", do: "var.met = var.met + 1" }],
  ports: [{ name: "over", when: "chi.After.port.done" }],
};

const banner = () => page.getByRole("region", { name: "Past" });
const moment = () => new URL(page.url()).searchParams.get("at");
/** Of the moment, and of what waited, where that is known. */
const digests = () => page.getByRole("region", { name: "Moment" }).locator("dd code").evaluateAll((all) => all.map((each) => each.getAttribute("title")));
const isActive = (path: string) => page.getByRole("treeitem", { name: path, exact: true }).getAttribute("data-active");
/** Names of the active states and barriers, of the drawing and of the tree. */
const active = async () => {
  const names = (all: readonly Element[]) => [...new Set(all.map((each) => each.getAttribute("data-path")))].sort().join(" ");
  const drawn = await page.locator('.canvas [data-path][data-active="true"]').evaluateAll(names);
  const listed = await page.locator('[role="treeitem"][data-active="true"]').evaluateAll((all) => [...new Set(all.map((each) => each.getAttribute("data-path")))].sort().join(" "));
  expect(listed).toContain(drawn.split(" ")[0]);
  return listed;
};

/** The same, as the server has it. */
async function activeThen(id: string, at: string): Promise<string> {
  const [step = "", micro = ""] = at.split(".");
  const { state } = (await fixture.send("GET", `/cores/${id}/past?step=${step}&micro=${micro}`)) as { readonly state: { readonly active: readonly string[] } };
  return [...state.active].sort().join(" ");
}

/** Presses a key that moves, and waits until the page is there. */
async function go(key: string): Promise<string> {
  const before = moment();
  await page.keyboard.press(key);
  await soon(moment).not.toBe(before);
  return moment() ?? "present";
}

describe("going back", () => {
  let id: string;
  const seen = new Map<string, { readonly digests: readonly (string | null)[]; readonly active: string }>();
  const note = async () => {
    const at = moment() ?? "";
    await soon(() => page.getByRole("heading", { level: 2, name: `Step ${at}`, exact: true }).count()).toBe(1);
    await soon(active).toBe(await activeThen(id, at));
    return [at, { digests: await digests(), active: await active() }] as const;
  };

  it("leads by F9 over the barrier, micro step by micro step, to the beginning", async () => {
    await send("PUT", "/documents/meeting", { rcm: 1, name: "meeting", root: meeting });
    ({ id } = await send("POST", "/cores", { document: "meeting" }));
    await send("POST", `/cores/${id}/start`);
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(page);
    await soon(() => isActive("Root/After")).toBe("true");
    expect(await banner().count()).toBe(0);
    for (let at = await go("F9"); ; at = await go("F9")) {
      const [, now] = await note();
      seen.set(at, now);
      if (at === "1.0") break;
      expect(seen.size).toBeLessThan(40);
    }
    const states = [...seen.values()].map((each) => each.active);
    // The last micro step entered After, through the barrier; before it, the barrier had not opened.
    expect(states.filter((each) => each.includes("Root/After"))).toEqual([]);
    expect(states).toEqual(expect.arrayContaining(["Root Root/A Root/B", "Root Root/B", ""]));
    expect(new Set([...seen.values()].map((each) => each.digests[0])).size).toBe(seen.size);
    const waited = [...seen.values()].flatMap((each) => each.digests.slice(1));
    expect(waited.length).toBeGreaterThan(0);
    for (const each of waited) expect(each).toMatch(/^[0-9a-f]{64}: equal if the same inputs waited$/);
  });

  it("leads forward again through the same moments, with the same digests, to the present", async () => {
    const again: string[] = ["1.0"];
    for (let at = await go("Shift+F9"); at !== "present"; at = await go("Shift+F9")) {
      again.push(at);
      const [, now] = await note();
      // Of the moment and of what waited; of the newest moment, what waited may not have been known before.
      const before = seen.get(at);
      if (before !== undefined) expect({ ...now, digests: now.digests.slice(0, before.digests.length) }, at).toEqual(before);
      expect(again.length).toBeLessThan(60);
    }
    expect(again).toEqual(expect.arrayContaining([...seen.keys()].reverse()));
    await soon(() => isActive("Root/After")).toBe("true");
    await soon(() => banner().count()).toBe(0);
  });

  it("is said over the whole page, and leaves the run where it is", async () => {
    const before = await core(id);
    await go("F9");
    await go("Control+F9");
    const { step } = before;
    await soon(moment).toMatch(/\.\d+$/);
    await soon(() => banner().innerText()).toContain(`You look at step ${moment() ?? ""}. The run is at ${step}. Robots do not move back.`);
    await soon(async () => (await banner().boundingBox())?.width).toBe(1366);
    await soon(() => page.getByRole("toolbar", { name: "Run", exact: true }).getByText("The present").isVisible()).toBe(true);
    expect(await core(id)).toEqual(before);
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("past");
    await page.emulateMedia({ colorScheme: "dark" });
    await soon(() => findings(page)).toEqual([]);
    await fixture.screenshot("past-dark");
    await page.emulateMedia({ colorScheme: "light" });
  });

  it("shows values, what waited, open calls, and why a port did not fire then", async () => {
    await page.goto(`${fixture.url}/pro/?run=${id}&at=1.99`);
    await settled(page);
    const calls = page.getByRole("region", { name: "Open calls" });
    await soon(async () => (await calls.getByRole("listitem").allInnerTexts()).map((text) => text.replace(/\s+/g, " "))).toEqual(["timer.wait call 1 by Root/A", "timer.wait call 2 by Root/B"]);
    const waiting = page.getByRole("region", { name: "Inputs waiting" });
    await soon(async () => (await waiting.getByRole("listitem").allInnerTexts()).map((text) => text.replace(/\s+/g, " "))).toEqual([expect.stringMatching(/^response timer\.wait → .* delivered in step 2$/)]);
    await page.getByRole("button", { name: "Select Root", exact: true }).click();
    const values = page.getByRole("region", { name: "Variables" });
    await soon(() => values.innerText()).toMatch(/met\s+0/);
    await page.getByRole("button", { name: "Port Root/B.done", exact: true }).click();
    const why = page.getByRole("region", { name: "Why", exact: true });
    await soon(() => why.innerText()).toMatch(/svc\.timer\.wait\.result[^]*Condition at step 1\.\d+: (false|unknown)/);
    await page.keyboard.press("Escape");
    await soon(moment).toBeNull();
    await soon(() => page.getByRole("region", { name: "Why it fired" }).count()).toBe(1);
  });

  it("is in the address: the browser's Back leads to the moment before, and a link to it is enough", async () => {
    const at = await go("F9");
    const then = await activeThen(id, at);
    await soon(active).toBe(then);
    await go("Control+F9");
    await page.goBack();
    await soon(moment).toBe(at);
    await soon(active).toBe(then);
    const other = await fixture.openPage({ width: 1366, height: 768 });
    await other.goto(page.url());
    await soon(() => other.getByRole("region", { name: "Past" }).innerText()).toContain(`You look at step ${at}.`);
    await other.context().close();
    await page.getByRole("button", { name: "Now" }).click();
    await soon(moment).toBeNull();
    await page.goBack();
    await soon(() => banner().innerText()).toContain(`You look at step ${at}.`);
  });

  it("is told when there is no such moment, and shows the present", async () => {
    fixture.allowError(/400 .*past\?step=999/);
    await page.goto(`${fixture.url}/pro/?run=${id}&at=999.0`);
    await soon(() => page.locator(".problem").innerText()).toMatch(/there are macro steps 1 to \d+/);
    await soon(moment).toBeNull();
    await soon(() => banner().count()).toBe(0);
  });

  it("comes of a step that is picked in the derivation, and of the slider", async () => {
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(page);
    if ((await page.getByRole("list", { name: "Macro steps" }).count()) === 0) await page.getByRole("tab", { name: "Derivation" }).click();
    const steps = page.getByRole("list", { name: "Macro steps" }).getByRole("button");
    await steps.first().click();
    await soon(() => banner().innerText()).toContain("You look at step 1.");
    await soon(() => steps.first().getAttribute("aria-current")).toBe("step");
    await soon(active).toBe("Root Root/A Root/B");
    const slider = banner().getByRole("slider", { name: "Macro step" });
    await slider.focus();
    await slider.press("ArrowRight");
    await soon(moment).toMatch(/^2\./);
    await soon(() => steps.nth(1).getAttribute("aria-current")).toBe("step");
    await slider.press("End");
    await soon(moment).toMatch(new RegExp(`^${(await core(id)).step}\\.`));
    await page.getByRole("checkbox", { name: "Follow the run" }).check();
    await soon(() => banner().count()).toBe(0);
  });
});

describe("going back in a run that was edited", () => {
  it("shows the model of that step", async () => {
    const task = { rcm: 1, root: { state: "Root", first: "A", ports: [{ name: "done", when: "False" }], children: [{ state: "A", ports: [{ name: "next", when: "False", to: "B" }] }, { state: "B" }] } };
    const { document } = (await fixture.send("PUT", "/documents/changing", task)) as { readonly document: { readonly root: { readonly children: readonly { readonly meta: { readonly id: string } }[] } } };
    const { id } = await send("POST", "/cores", { document: "changing" });
    await fixture.send("PUT", `/cores/${id}/live`, { live: true });
    await send("POST", `/cores/${id}/start`);
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await soon(() => isActive("Root/A")).toBe("true");
    await fixture.send("POST", "/documents/changing/edits", { revision: 1, author: "Ada", compound: { kind: "rename", id: document.root.children[1]?.meta.id ?? "", name: "Later" } });
    await soon(async () => (await core(id)).revision).toBe(2);
    await page.locator('.canvas [data-path="Root/Later"]').waitFor();
    await page.keyboard.press("Control+F9");
    await soon(moment).toMatch(/^1\./);
    await page.locator('.canvas [data-path="Root/B"]').waitFor();
    await soon(() => page.getByRole("treeitem", { name: "Root/Later" }).count()).toBe(0);
    await soon(() => banner().innerText()).not.toContain("may be another");
    await page.keyboard.press("Escape");
    await page.locator('.canvas [data-path="Root/Later"]').waitFor();
  });
});

describe("the camera", () => {
  /** It looks for parts until the recognition has seen some, and rests; then all is over. */
  const looking = {
    state: "Root", first: "Begin",
    children: [
      { state: "Begin", entry: "svc.timer.wait(0.05)", ports: [{ name: "done", when: "svc.timer.wait.result", to: "Look" }] },
      { state: "Look", entry: "svc.obj_rec.start()", exit: "svc.obj_rec.stop()", ports: [{ name: "seen", when: "svc.obj_rec.recognized_objects", to: "Rest" }] },
      { state: "Rest", entry: "svc.timer.wait(0.2)", ports: [{ name: "done", when: "svc.timer.wait.result" }] },
    ],
    ports: [{ name: "over", when: "chi.Rest.port.done" }],
  };
  const camera = () => page.getByRole("region", { name: "Camera" });

  it("shows in the past what it saw then, and that it had seen nothing yet; also of a run that came as a file", async () => {
    await send("PUT", "/documents/looking", { rcm: 1, name: "looking", root: looking });
    const { id } = await send("POST", "/cores", { document: "looking" });
    await send("POST", `/cores/${id}/start`);
    await soon(async () => ((await fixture.send("GET", `/cores/${id}`)) as { readonly outcome?: string }).outcome).toBe("over");
    const { pictures } = (await fixture.send("GET", `/runs/${id}/pictures`)) as { readonly pictures: readonly { readonly step: number }[] };
    expect(pictures.length).toBeGreaterThan(0);
    for (const none of ["none", "1x", "-1", "400000", ""]) expect((await fetch(`${fixture.url}/api/v1/runs/${id}/pictures/${none}`)).status).toBe(404);
    const { step: last } = await core(id);
    // As text: numbers stay as they are.
    const file = await (await fetch(`${fixture.url}/api/v1/runs/${id}/export`)).text();
    const again = (await (await fetch(`${fixture.url}/api/v1/runs`, { method: "POST", body: file, headers: { "content-type": "application/json" } })).json()) as CoreJson;
    for (const run of [id, again.id]) {
      await page.goto(`${fixture.url}/pro/?run=${run}&at=${last}`);
      const picture = camera().getByRole("img");
      await picture.waitFor();
      await soon(() => picture.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBe(320);
      await page.goto(`${fixture.url}/pro/?run=${run}&at=1`);
      await camera().getByText("No picture had been taken yet.").waitFor();
    }
    await page.goto(`${fixture.url}/pro/?run=${id}&at=${last}`);
    await camera().getByRole("img").waitFor();
    await fixture.screenshot("past-camera");
    expect(await findings(page)).toEqual([]);
  });
});
