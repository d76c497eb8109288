// What the expert page shows while a task waits: a barrier that lacks a port, a pending call, and the log.
import { findings } from "./axe";
import { openFixture, settled, type Fixture } from "./fixture";
import { kSoon } from "./patience";

let fixture: Fixture;

beforeAll(async () => {
  fixture = await openFixture();
  await fixture.page.setViewportSize({ width: 1280, height: 800 });
});
afterAll(() => fixture.close());


async function post(path: string, body?: unknown, method = "POST"): Promise<{ readonly id: string }> {
  const answer = await fetch(`${fixture.url}/api/v1${path}`, { method, body: body === undefined ? null : JSON.stringify(body), headers: { "content-type": "application/json" } });
  if (!answer.ok) throw new Error(`${path}: ${answer.status} ${await answer.text()}`);
  return (await answer.json()) as { readonly id: string };
}

async function start(name: string, root: object): Promise<string> {
  await post(`/documents/${name}`, { rcm: 1, name, root }, "PUT");
  const core = await post("/cores", { document: name, arguments: {} });
  await post(`/cores/${core.id}/start`);
  return core.id;
}

const never = { name: "never", when: "False" };
/** A is done at once; B waits for the timer. */
const waiting = {
  state: "Root",
  first: "Split",
  children: [
    { barrier: "Split", to: ["A", "B"] },
    { state: "A", ports: [{ name: "done", when: "True", to: "Join" }] },
    { state: "B", entry: "svc.timer.start(3600)", ports: [{ name: "done", when: "svc.timer.start.error", to: "Join" }] },
    { barrier: "Join", to: ["End"] },
    { state: "End" },
  ],
  ports: [never],
};

const bar = () => fixture.page.locator('button[data-path="Root/Join"]');
const pending = () => fixture.page.getByRole("region", { name: "Pending calls of timer" });

describe("waiting", () => {
  it("is shown at the barrier: how many ports have arrived, and which have not", async () => {
    await start("waiting", waiting);
    await fixture.page.goto(`${fixture.url}/pro/`);
    await bar().waitFor();
    await expect.poll(() => bar().getAttribute("aria-label"), kSoon).toBe("Barrier Root/Join, waits for Root/B.done");
    await expect.poll(() => fixture.page.locator(".barrier-note").allInnerTexts(), kSoon).toEqual(["1/2"]);
    await settled(fixture.page);
    await bar().click();
    const list = fixture.page.getByRole("region", { name: "Waits for" });
    await expect.poll(() => list.getByRole("heading").innerText(), kSoon).toBe("1 of 2 inbound ports have arrived");
    await expect.poll(async () => (await list.getByRole("listitem").allInnerTexts()).map((text) => text.split(/\s+/)), kSoon).toEqual([["Root/A.done", "arrived"], ["Root/B.done", "waits"]]);
    await fixture.screenshot("waiting-barrier");
  });

  it("is shown at the service: the pending call and its run", async () => {
    await fixture.page.getByRole("tab", { name: /Services/ }).click();
    await expect.poll(() => pending().innerText(), kSoon).toMatch(/start\s*call \d+ of run 1 · since \d+\.\d\d s/);
    await expect.poll(() => pending().getByRole("listitem").count(), kSoon).toBe(1);
    await pending().scrollIntoViewIfNeeded();
    await fixture.screenshot("waiting-pending");
    await fixture.page.getByRole("tab", { name: "Task" }).click();
    await fixture.page.keyboard.press("Escape");
    const open = fixture.page.getByRole("region", { name: "Open calls" });
    const seconds = async () => Number(/timer\.start\s*called (\d+\.\d) s ago/.exec(await open.innerText())?.[1]);
    await expect.poll(seconds, kSoon).toBeGreaterThan(0);
    const before = await seconds();
    await expect.poll(seconds, kSoon).toBeGreaterThan(before);
    await fixture.page.getByRole("tab", { name: /Services/ }).click();
  });

  it("ends with the answer: the call is gone and the barrier has opened", async () => {
    await start("cancelling", { state: "Root", entry: "print('nobody waits so long')\nsvc.timer.cancel()", ports: [never] });
    await expect.poll(() => pending().innerText(), kSoon).toMatch(/None\./);
    await fixture.page.getByRole("tab", { name: "Task" }).click();
    await fixture.page.getByRole("combobox", { name: "Watched run" }).selectOption("1");
    await expect.poll(() => fixture.page.locator('.canvas [data-path="Root/End"]').getAttribute("data-active"), kSoon).toBe("true");
    await expect.poll(() => bar().getAttribute("aria-label"), kSoon).toBe("Barrier Root/Join, 2 inbound ports");
    await expect.poll(() => fixture.page.locator(".barrier-note").count(), kSoon).toBe(0);
  });

  it("leaves what the tasks printed in the log, which a filter searches", async () => {
    await fixture.page.getByRole("tab", { name: "Log" }).click();
    const line = fixture.page.getByRole("log").locator(".log-line").filter({ hasText: "nobody waits so long" });
    await line.waitFor(kSoon);
    await expect.poll(async () => (await line.innerText()).split(/\n+/), kSoon).toEqual([expect.stringMatching(/^\d+\.\d{3} s$/), "core/2", "nobody waits so long"]);
    const filter = fixture.page.getByRole("searchbox", { name: "Filter the log" });
    await filter.fill("CORE/2");
    await expect.poll(() => line.count()).toBe(1);
    expect(await fixture.page.locator(".log-line b").allInnerTexts()).not.toContain("core/1");
    await fixture.screenshot("waiting-log");
    await filter.fill("no such word");
    await fixture.page.getByText("No lines.").waitFor();
  });

  it("is shown of an edit: a list that scrolls, and errors that lead to what the run has of them", async () => {
    const names = Array.from({ length: 24 }, (_, i) => `Step${i}`);
    const steps = (to: string) => names.map((state) => ({ state, ports: [{ name: "next", when: "False", to }] }));
    const task = (...children: readonly object[]) => ({ rcm: 1, name: "edited", root: { state: "Root", children: [...children, { state: "End" }], ports: [never] } });
    const id = await start("edited", { ...task({ barrier: "Split", to: names }, ...steps("End")).root, first: "Split" });
    await post(`/cores/${id}/live`, { live: true }, "PUT");
    await post("/documents/edited", task(), "PUT");
    await fixture.page.setViewportSize({ width: 390, height: 844 });
    await fixture.page.goto(`${fixture.url}/pro/?run=${id}`);
    const panel = fixture.page.getByRole("status", { name: "Waiting edit" });
    await expect.poll(() => panel.getByRole("button").count(), kSoon).toBe(names.length);
    await expect.poll(() => panel.getByRole("listitem").first().innerText(), kSoon).toBe("Root/Step0 is active, and the edit removes it");
    await expect.poll(async () => (await panel.boundingBox())?.height, kSoon).toBeLessThan(200);
    await fixture.screenshot("waiting-edit");

    await fixture.page.setViewportSize({ width: 1280, height: 800 });
    await post("/documents/edited?draft=true", task(...steps("Nowhere"), { state: "New", ports: [{ ...never, to: "Nowhere" }] }), "PUT");
    await expect.poll(() => panel.innerText(), kSoon).toContain(`has ${names.length + 1} errors and cannot be executed`);
    await expect.poll(async () => [await panel.getByRole("listitem").count(), await panel.getByRole("button").count()], kSoon).toEqual([names.length + 1, names.length]);
    await fixture.page.reload();
    await expect.poll(() => panel.getByRole("button").count(), kSoon).toBe(names.length);
    await expect.poll(() => panel.innerText(), { ...kSoon, message: "also on a page that is opened later" }).toContain("cannot be executed");
    await panel.getByRole("button").first().click();
    await fixture.page.locator(".port.is-selected").waitFor(kSoon);
    await fixture.screenshot("waiting-edit-refused");
  });

  it("is shown of a run that is paused: each input that has come and is not delivered", async () => {
    const { page } = fixture;
    const id = await start("held", { state: "Root", entry: "svc.timer.wait(0.2)", actions: [{ when: "svc.timer.wait.result", do: "print('waited')" }], ports: [{ name: "done", when: "svc.timer.wait.result" }] });
    await post(`/cores/${id}/pause`);
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    const held = page.getByRole("region", { name: "Inputs waiting" });
    await held.getByText(/response timer\.wait/).waitFor(kSoon);
    await expect.poll(async () => (await held.getByRole("listitem").allInnerTexts()).map((text) => text.split(/\n+/)[1]), kSoon).toEqual(["the next step delivers it"]);
    await page.getByText("Paused: the task takes no more inputs; a motion that was called goes on to its end, and the time-outs of open calls run on.").waitFor(kSoon);
    await fixture.screenshot("waiting-held");
    await settled(page);
    await page.getByRole("button", { name: "Port Root.done", exact: true }).click();
    await page.getByRole("region", { name: "Why" }).getByText("timer.wait: its response is queued; a step delivers it").waitFor(kSoon);
    await page.getByText("Ends the task: the run is over when it fires.").waitFor();
    await fixture.screenshot("waiting-held-why");
    await page.keyboard.press("Escape");
    await held.waitFor(kSoon);
    await page.getByRole("button", { name: "Macro step" }).click();
    await held.waitFor({ state: "detached" });
  });

  it("for a display that is not there is amber too, and this page can be one: its texts and questions are read here", async () => {
    const { page } = fixture;
    await post("/documents/unheard", { rcm: 1, name: "unheard", root: { state: "Root", entry: "svc.display.ask('Ready?')", ports: [never] } }, "PUT");
    const id = await start("unseen", {
      state: "Root", first: "Ask",
      children: [
        {
          state: "Ask", entry: "svc.display.ask('Is the table empty?', ['Yes', 'No'])",
          ports: [{ name: "on", when: "svc.display.ask.result.answer == 'Yes'", to: "Lead" }, { name: "again", when: "svc.display.ask.error", to: "Pause" }],
        },
        { state: "Pause", ports: [{ name: "over", after: "0.5", to: "Ask" }] },
        { state: "Lead", entry: "svc.display.show_text('Lead the arm by hand')" },
      ],
      ports: [never],
    });
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    const unseen = page.getByRole("alert", { name: "Waiting for a display" });
    await unseen.getByText("No display is connected: nobody was asked “Is the table empty?”").waitFor(kSoon);
    await expect.poll(() => page.getByRole("status", { name: "Run status" }).innerText(), kSoon).toContain("Waiting for a display");
    expect(await unseen.getByRole("link", { name: "Open a display" }).getAttribute("href")).toBe("/display/");
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("waiting-display");
    await unseen.getByRole("button", { name: "Answer on this page" }).click();
    const asked = page.getByRole("alert", { name: "Waiting for a person" });
    await asked.getByText("Waiting for a person: Is the table empty?").waitFor(kSoon);
    await page.getByRole("region", { name: "Open calls" }).getByText(/“Is the table empty\?”, called/).waitFor(kSoon);
    await expect.poll(() => unseen.count(), kSoon).toBe(0);
    await asked.getByRole("button", { name: "Yes" }).click();
    await page.getByRole("status", { name: "On the displays" }).getByText("Told on every display: Lead the arm by hand").waitFor(kSoon);
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("waiting-instruction");
    await page.getByText("This page acts as the display expert-page.").getByRole("button", { name: "Disconnect" }).click();
    await expect.poll(() => page.getByText("This page acts as the display").count()).toBe(0);
    await post(`/cores/${id}/stop`);
    await page.getByRole("status", { name: "On the displays" }).waitFor({ state: "detached" });
    const deaf = await post("/cores", { document: "unheard", arguments: {} });
    await page.goto(`${fixture.url}/pro/?run=${deaf.id}`);
    await page.getByRole("button", { name: "Start", exact: true }).click();
    await unseen.getByText("No display has taken the question “Ready?”").waitFor(kSoon);
  });

  it("for a person is amber, with the answers in place", async () => {
    const { page } = fixture;
    const phone = await (await fixture.openContext({})).newPage();
    await phone.goto(`${fixture.url}/display/?name=phone`);
    await phone.getByRole("status", { name: "Connection" }).filter({ hasText: "Connected" }).waitFor();
    const id = await start("asking", {
      state: "Root", first: "Ask",
      children: [
        { state: "Ask", entry: "svc.display.ask('What is to be done?', ['Continue', 'Abort'])", ports: [{ name: "on", when: "svc.display.ask.result.answer == 'Continue'", to: "Count" }] },
        { state: "Count", entry: "svc.display.ask_number('How many parts?', 1, 9)", ports: [{ name: "done", when: "svc.display.ask_number.result.answer == 3", to: "End" }] },
        { state: "End" },
      ],
      ports: [never],
    });
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    const asked = page.getByRole("alert", { name: "Waiting for a person" });
    await asked.getByText("Waiting for a person: What is to be done?").waitFor(kSoon);
    await expect.poll(() => page.locator(".prop-head .pill").innerText(), kSoon).toBe("Waiting for a person");
    const colour = (name: string) => asked.getByRole("button", { name }).evaluate((button) => getComputedStyle(button).backgroundColor);
    expect(await colour("Abort")).not.toBe(await colour("Continue"));
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("waiting-person");
    await asked.getByRole("button", { name: "Continue" }).click();
    await asked.getByText("How many parts?").waitFor(kSoon);
    await asked.getByRole("textbox", { name: "Number" }).fill("10");
    await expect.poll(() => asked.getByRole("button", { name: "Answer" }).isEnabled(), kSoon).toBe(false);
    await asked.getByRole("textbox", { name: "Number" }).fill("3");
    await page.keyboard.press("Enter");
    await asked.waitFor({ state: "detached" });
    await expect.poll(() => page.locator('.canvas [data-path="Root/End"]').getAttribute("data-active"), kSoon).toBe("true");
  });
});
