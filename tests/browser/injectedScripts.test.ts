// No text of anybody runs a script on any page: what people, tasks, services and addresses say is text wherever it is shown.
import { execFileSync } from "node:child_process";
import type { BrowserContext, Page } from "playwright-core";
import { openBrowser } from "./chromium";
import { write } from "./editPage";
import { binary, openFixture, openPrepared, settled, textOf, type Fixture } from "./fixture";
import { callingTask, describedTask, faultingTask, groups, hostileDraft, hostileSkills, hostileTask, literal, unreadableDraft } from "./hostileTask";
import { NodeSocket } from "./nodeSocket";
import { kClobbered, payloads, payloadsByClass } from "./scriptPayloads";
import { shownOf, watchScripts, type ScriptWatch } from "./scriptWatch";
import { kPatience, kSoon } from "./patience";

/** What a page shows of some texts is cut, or begins with what is no letter: so many need not be found again. */
const kNearlyAll = payloads.length - 12;

let fixture: Fixture;
/** Without the policy by which browsers refuse what a page should not have had in the first place. */
let context: BrowserContext;
let page: Page;
let watch: ScriptWatch;

beforeAll(async () => {
  fixture = await openFixture();
  context = await fixture.openContext({ viewport: { width: 1600, height: 1000 }, bypassCSP: true, permissions: ["clipboard-read", "clipboard-write"] });
  watch = await watchScripts(context, fixture.url);
  page = await context.newPage();
  page.setDefaultTimeout(kPatience);
  await send("PUT", "/documents/hostile", hostileTask(groups.flat().map((text) => `print(${literal(text)})`).join("\n"), 3600));
  for (let i = 0; i < payloads.length; i += 4) await send("PUT", `/documents/described${i}`, describedTask(payloads.slice(i, i + 4).join(" | ")));
  await send("PUT", "/documents/draft?draft=true", hostileDraft);
});
afterAll(() => fixture.close());
afterEach(() => expect(watch.found()).toEqual([]));

const send = async (method: string, path: string, body?: unknown) => (await fixture.send(method, path, body)) as { readonly id: string; readonly status: string; readonly revision: number };
const seen = async (texts = payloads) => (await shownOf(texts, context)).size;

async function start(document: string): Promise<string> {
  const { id } = await send("POST", "/cores", { document });
  await send("POST", `/cores/${id}/start`);
  return id;
}

it("the texts run scripts, or ask another host, in a page that takes them for markup or for an address", async () => {
  expect([payloads.length, new Set(payloads).size]).toEqual([payloads.length, payloads.length]);
  expect(payloads.length).toBeGreaterThan(150);
  const browser = await openBrowser();
  const careless = await browser.newContext({ bypassCSP: true });
  const { found } = await watchScripts(careless, fixture.url);
  const bad = await careless.newPage();
  await bad.goto(`${fixture.url}/api/v1/health`);
  await bad.evaluate((texts) => {
    const frameOf = (i: number, markup?: string): Document | null => {
      const frame = document.createElement("iframe");
      frame.name = `payload ${i}`;
      if (markup !== undefined) frame.srcdoc = `<!doctype html>${markup}`;
      document.body.append(frame);
      return frame.contentDocument;
    };
    for (const [i, text] of texts.entries()) {
      frameOf(i, `<p style='animation-name:x'>${text}`);
      frameOf(i, `<p title="${text}">`);
      const [, address = text] = /\[x\](?:\(|: )\s*([^ )]+\)?)/.exec(text) ?? [];
      if (!URL.canParse(address, location.href) || new URL(address, location.href).origin === location.origin) continue;
      const links = frameOf(i);
      const link = links?.body.appendChild(links.createElement("a"));
      if (link === undefined) continue;
      link.href = address;
      link.click();
    }
  }, payloads);
  const numbers = new Set<string>();
  const count = () => {
    for (const text of found()) numbers.add(/^payload (\d+): (?:ran|request)/.exec(text)?.[1] ?? "");
    numbers.delete("");
    return numbers.size;
  };
  await expect.poll(count, kSoon).toBeGreaterThan(100);
  const byClass = Object.entries(payloadsByClass).map(([name, texts]) => `${name} ${texts.filter((text) => numbers.has(String(payloads.indexOf(text)))).length}/${texts.length}`);
  console.log(`run in a careless page: ${numbers.size} of ${payloads.length} (${byClass.join(", ")})`);
  await browser.close();
});

const tree = () => page.getByRole("tree", { name: "State tree" }).getByRole("treeitem");
const row = (path: string) => page.getByRole("treeitem", { name: path, exact: true }).locator(".tree-name");
const properties = () => page.getByRole("complementary", { name: "Properties" });
/** Presses all of them, also what is out of sight. */
const pressAll = (selector: string) => page.evaluate((which) => document.querySelectorAll(which).forEach((each) => each instanceof HTMLElement && each.click()), selector);
const rest = () => page.waitForTimeout(100);

/** Those of the texts that the page shows, once it shows all of them, or for a while no more: some are cut wherever they stand. */
async function shownAtRest(texts: readonly string[]): Promise<ReadonlySet<string>> {
  const found = new Set<string>();
  for (let looks = 0; looks < 15 && found.size < texts.length; looks++) {
    await rest();
    for (const text of await shownOf(texts, context)) found.add(text);
  }
  return found;
}

/** The events of a person on all that is shown: what is under the pointer, has the focus, or is pressed and taken back. */
const touchAll = () =>
  page.evaluate(() => {
    for (const each of document.querySelectorAll("#root *")) for (const type of ["pointerenter", "pointerover", "mouseover", "mouseenter"]) each.dispatchEvent(new MouseEvent(type, { bubbles: true }));
  });

async function openRun(id: string, more = ""): Promise<void> {
  await page.goto(`${fixture.url}/pro/?run=${id}${more}`);
  await settled(page);
}

describe("a document whose texts are those of an attacker", () => {
  const people: NodeSocket[] = [];
  const saying: ReturnType<typeof setInterval>[] = [];
  beforeAll(async () => {
    let revision = 1;
    for (const [i, text] of payloads.slice(0, 100).entries()) {
      const author = text.replace(/[^ -}]/g, "").slice(0, 90);
      ({ revision } = await send("POST", "/documents/hostile/edits", { revision, author, message: text, operations: [{ op: "set", id: `s${i % groups.length}`, field: "doc", value: `${text}\n${groups[i % groups.length]?.join("\n") ?? ""}` }] }));
    }
    const short = payloads.filter((text) => text.length <= 40 && /^[ -~]+$/.test(text) && text.trim() !== "");
    for (const [i, name] of short.slice(0, 60).entries()) {
      const socket = new NodeSocket(`${fixture.url.replace("http", "ws")}/api/v1/stream`);
      const say = () => socket.send(JSON.stringify({ type: "presence", document: "hostile", name, selection: [`s${i % groups.length}`], pointer: { element: `s${i % groups.length}`, x: 5, y: 5 }, text: { element: "s0", field: "entry", offset: i } }));
      socket.onopen = say;
      people.push(socket);
      saying.push(setInterval(say, 10_000));
    }
    const breakpoints = payloads.slice(0, 90).map((text, i) => ({ when: "entered", path: `Root/S${i % groups.length}`, condition: `par.p0 == ${literal(text)}`.slice(0, 500), enabled: true }));
    await page.goto(`${fixture.url}/pro/`);
    await page.evaluate((name) => localStorage.setItem("race.name", name), payloads[0] ?? "");
    await send("PUT", `/documents/hostile/breakpoints?author=${encodeURIComponent(payloads[0] ?? "")}`, { breakpoints });
  });
  afterAll(() => {
    saying.forEach(clearInterval);
    people.forEach((socket) => socket.close());
  });

  it("is listed and begun", async () => {
    await page.goto(`${fixture.url}/pro/`);
    await page.getByRole("listitem", { name: "described0", exact: true }).first().waitFor();
    await page.keyboard.press("Control+o");
    const search = page.getByRole("searchbox", { name: "Search the documents" });
    await search.waitFor();
    await expect.poll(() => seen(), kSoon).toBeGreaterThan(kNearlyAll);
    for (const { 0: text = "" } of groups) await search.fill(text);
    await page.keyboard.press("Escape");
    await page.keyboard.press("Escape");
    await page.getByRole("combobox", { name: "Document" }).selectOption("hostile");
    await page.getByRole("button", { name: "Arguments…" }).click();
    const form = page.getByRole("dialog", { name: /^Arguments/ });
    await form.waitFor();
    await expect.poll(() => seen(), kSoon).toBeGreaterThan(kNearlyAll);
    for (const { 1: text = "" } of groups) {
      await form.getByRole("textbox").last().fill(text);
      await form.getByRole("textbox").first().fill(text);
    }
    await touchAll();
    await page.keyboard.press("Escape");
  });

  it("is drawn and edited: each state with its forms, notes, comments and code", async () => {
    await page.goto(`${fixture.url}/pro/?edit=hostile`);
    await settled(page);
    const found = new Set<string>();
    for (const i of groups.keys()) {
      await row(`Root/S${i}`).click();
      await properties().getByRole("textbox", { name: "Name", exact: true }).first().waitFor();
      await pressAll('[aria-label="Type, unit and description"][aria-expanded="false"]');
      for (const text of await shownAtRest(groups[i] ?? [])) found.add(text);
    }
    expect(found.size).toBeGreaterThan(kNearlyAll);
    await touchAll();
    await page.getByRole("button", { name: "Wide form" }).click();
    await page.getByRole("region", { name: /^State editor/ }).waitFor();
    await rest();
    await page.getByRole("button", { name: "Close the state editor" }).click();
    await row("Root").click();
    await rest();
    await expect.poll(() => seen(), kSoon).toBeGreaterThan(kNearlyAll);
  });

  it("says who is there, who has commented and who has changed what", async () => {
    await expect.poll(() => page.locator(".face").count(), kSoon).toBeGreaterThan(2);
    await page.getByRole("button", { name: /open comments/ }).first().click();
    await page.getByRole("region", { name: "Open comments" }).waitFor();
    await expect.poll(() => seen(), kSoon).toBeGreaterThan(kNearlyAll);
    await page.keyboard.press("Control+Shift+H");
    const history = page.getByRole("region", { name: "History" });
    await history.locator(".revision-row").first().waitFor();
    await pressAll('[aria-label$="one by one"][aria-expanded="false"]');
    await rest();
    for (const at of [0, 1, 40, 90]) {
      await history.locator(".revision-row").nth(at).click();
      await history.getByRole("list", { name: "Changes" }).or(history.getByText("Nothing differs.")).first().waitFor();
    }
    await expect.poll(async () => (await shownOf(payloads.slice(0, 100), context)).size, kSoon).toBeGreaterThan(80);
    await touchAll();
    await history.getByRole("button", { name: "Close the history" }).click();
  });

  it("is searched, asked for usages, commanded, and pasted into", async () => {
    const search = page.getByRole("searchbox", { name: "Search the model" });
    for (const text of payloads.filter((_, i) => i % 2 === 0)) {
      await search.evaluate((field, value) => {
        Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field, value);
        field.dispatchEvent(new Event("input", { bubbles: true }));
      }, text);
    }
    for (const { 2: text = "" } of groups) {
      await search.fill(text.slice(0, 12));
      await rest();
    }
    await search.fill("");
    await row("Root/S3").click();
    await page.locator("#edit-canvas").focus();
    await page.keyboard.press("Control+Shift+p");
    await page.getByRole("dialog", { name: "Commands" }).getByRole("combobox").fill("usages");
    await page.keyboard.press("Enter");
    await rest();
    await page.keyboard.press("Escape");
    const told = page.getByRole("log", { name: "Refused edits" });
    const pasted = [...payloads.filter((_, i) => i % 16 === 0), JSON.stringify({ state: payloads[0], doc: payloads[1] }), `{"state":"X","doc":${JSON.stringify(payloads[2])},"__proto__":{"${kClobbered}":1},"meta":{"__proto__":{"${kClobbered}":1}}}`];
    for (const text of pasted) {
      await page.locator("#edit-canvas").focus();
      await page.evaluate((content) => navigator.clipboard.write([new ClipboardItem({ "text/plain": content, "text/html": content })]), text);
      await page.keyboard.press("Control+v");
    }
    await told.getByRole("listitem").or(told.locator("p")).first().waitFor();
    await row("Root/S3").click();
    // Texts that are marked up, into a text field, into code, and into what is a number.
    for (const field of [properties().getByRole("textbox", { name: "Description" }).first(), properties().getByRole("textbox", { name: "Entry" })]) {
      for (const text of pasted.slice(0, 12)) {
        await field.click();
        await page.evaluate((content) => navigator.clipboard.write([new ClipboardItem({ "text/plain": content, "text/html": content })]), text);
        await page.keyboard.press("Control+v");
      }
      await page.keyboard.press("Control+Enter");
      await rest();
    }
    await row("Root/S5").click();
    const code = properties().getByRole("textbox", { name: "Entry" });
    await write(code, "print(par.p0)\npar.");
    await page.locator(".cm-tooltip-autocomplete li").filter({ hasText: "p0" }).first().waitFor();
    await page.keyboard.press("ArrowDown");
    await rest();
    await write(code, "print(par.p0)");
    // The name has no element of its own.
    const name = await code.locator(".cm-line").first().evaluate((line) => {
      const walker = document.createTreeWalker(line, NodeFilter.SHOW_TEXT);
      const range = document.createRange();
      for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
        const at = node.nodeValue?.indexOf("p0") ?? -1;
        if (at < 0) continue;
        range.setStart(node, at);
        range.setEnd(node, at + 2);
      }
      const { x, y, width, height } = range.getBoundingClientRect();
      return { x: x + width / 2, y: y + height / 2 };
    });
    await page.mouse.move(name.x, name.y, { steps: 3 });
    await page.locator(".code-hover").first().waitFor();
    await page.keyboard.press("Escape");
    await page.locator("#edit-canvas").focus();
    await page.keyboard.press("F2");
    const field = page.getByRole("textbox", { name: /^Name of / });
    for (const { 3: text = "" } of groups) await field.fill(text);
    await page.keyboard.press("Enter");
    await rest();
    await page.keyboard.press("Escape");
  });

  it("has names that are none, and more errors than can be told", async () => {
    await send("PUT", "/documents/unreadable?draft=true", unreadableDraft);
    await page.goto(`${fixture.url}/pro/?edit=unreadable`);
    await page.getByText("unreadable cannot be edited").waitFor();
    await page.goto(`${fixture.url}/pro/?edit=draft`);
    await page.getByRole("region", { name: "Errors" }).waitFor();
    await settled(page);
    const count = await tree().count();
    for (let i = 0; i < count; i += 20) {
      await tree().nth(i).locator(".tree-name").click();
      await rest();
    }
    for (const item of [0, 50, 120]) await page.getByRole("region", { name: "Errors" }).getByRole("button").nth(item).click();
    await touchAll();
    await expect.poll(async () => (await shownOf(payloads, context)).size, kSoon).toBeGreaterThan(200);
    // The files that are saved, opened by themselves.
    const [file] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save as SVG" }).click()]);
    const svg = await context.newPage();
    await svg.goto(`data:image/svg+xml,${encodeURIComponent(await textOf(file))}`);
    await svg.waitForTimeout(300);
    expect(await svg.locator("parsererror").count()).toBe(0);
    await svg.close();
  });
});

describe("a run of such a task", () => {
  const kPerFault = 64;
  let ended: string;
  beforeAll(async () => {
    await send("PUT", "/documents/over", hostileTask(groups.map(([text = ""]) => `svc.robot.move(target=${literal(text)})`).join("\n"), 1));
    ended = (await send("POST", "/cores", { document: "over", arguments: { text: payloads.join(" "), texts: payloads, choice: payloads[9] } })).id;
    await send("PUT", `/cores/${ended}/breakpoints?author=${encodeURIComponent(payloads[5] ?? "")}`, { breakpoints: groups.map(([text = ""], i) => ({ when: "entered", path: `Root/S${i}`, condition: `par.p0 == ${literal(text)} + "x"` })) });
    await send("POST", `/cores/${ended}/start`);
    while ((await send("GET", `/cores/${ended}`)).status === "running") await new Promise((resolve) => setTimeout(resolve, 100));
    for (let i = 0; i < payloads.length; i += kPerFault) {
      await send("PUT", "/documents/faulting", faultingTask(payloads.slice(i, i + kPerFault).join(" | ")));
      await start("faulting");
    }
  });

  it("shows values, results, code and conditions of each state, and what was selected", async () => {
    await openRun(ended);
    await expect.poll(() => seen(), kSoon).toBeGreaterThan(kNearlyAll);
    const found = new Set<string>();
    for (const i of groups.keys()) {
      await row(`Root/S${i}`).click();
      for (const text of await shownAtRest(groups[i] ?? [])) found.add(text);
    }
    expect(found.size).toBeGreaterThan(kNearlyAll);
    await openRun(ended, "&sel=Root/S1.q0");
    await page.getByRole("region", { name: "Why" }).waitFor();
    await touchAll();
  });

  it("shows its log, derivation, time line and calls", async () => {
    await page.getByRole("tab", { name: "Log" }).click();
    await page.getByRole("log").locator(".log-line").first().waitFor();
    await expect.poll(() => seen(), kSoon).toBeGreaterThan(kNearlyAll);
    const filter = page.getByRole("searchbox", { name: "Filter the log" });
    for (const { 4: text = "" } of groups) await filter.fill(text);
    for (const name of ["Derivation", "Time line", "Calls"]) {
      await page.getByRole("tab", { name }).click();
      await rest();
      await touchAll();
    }
    const calls = page.getByRole("searchbox", { name: "Text of calls and events" });
    for (const { 5: text = "" } of groups) await calls.fill(text);
    await calls.fill("");
    await page.keyboard.press("F9");
    await page.getByRole("region", { name: "Past" }).waitFor();
    await row("Root/S2").click();
    await rest();
    await page.getByRole("tab", { name: "Derivation" }).click();
    await rest();
  });

  it("is among the stored runs, with faults that say such a text", async () => {
    const faulting = async () => {
      const { cores } = (await fixture.send("GET", "/cores")) as { readonly cores: readonly { readonly id: string; readonly status: string }[] };
      return cores.filter(({ status }) => status === "faulted").map(({ id }) => id);
    };
    await expect.poll(faulting, kSoon).toHaveLength(Math.ceil(payloads.length / kPerFault));
    const faulted = await faulting();
    const found = new Set<string>();
    for (const id of faulted) {
      await openRun(id);
      await page.getByRole("region", { name: "Fault" }).waitFor();
      for (const text of await shownOf(payloads, context)) found.add(text);
    }
    expect(found.size).toBeGreaterThan(kNearlyAll);
    await page.getByRole("button", { name: "Runs", exact: true }).click();
    const list = page.getByRole("list", { name: "Stored runs" });
    await list.getByRole("listitem").first().waitFor();
    const search = page.getByRole("searchbox", { name: "Search the runs" });
    for (const { 6: text = "" } of groups) await search.fill(text);
    await search.fill("");
    await list.getByRole("button", { name: "Compare" }).last().click();
    await rest();
    await page.keyboard.press("Escape");
  });

  it("comes as a file: with texts that are no run, and with names of files", async () => {
    fixture.allowError(/status of 4\d\d/);
    const text = await (await fetch(`${fixture.url}/api/v1/runs/${ended}/export`)).text();
    const run = JSON.parse(text) as { readonly run: object };
    const files = [
      ...payloads.filter((_, i) => i % 8 === 3).map((name) => ({ name, text: JSON.stringify({ rcm: 1, name, root: { state: name, [name]: name } }) })),
      ...payloads.slice(0, 6).map((name) => ({ name: `${name}.json`, text: JSON.stringify({ ...run, run: { ...run.run, document: name, outcome: name } }) })),
      { name: "__proto__", text: `{"rcm":1,"__proto__":{"${kClobbered}":1},"root":{"state":"Root","meta":{"__proto__":{"${kClobbered}":1},"constructor":{"prototype":{"${kClobbered}":1}}}}}` },
      { name: payloads[0] ?? "", text },
    ];
    await page.goto(`${fixture.url}/pro/`);
    await page.getByText("Connected", { exact: true }).waitFor();
    await page.evaluate((all) => {
      const dropped = new DataTransfer();
      for (const each of all) dropped.items.add(new File([each.text], each.name, { type: "text/html" }));
      const drop = { bubbles: true, cancelable: true, dataTransfer: dropped };
      document.body.dispatchEvent(new DragEvent("dragenter", drop));
      document.body.dispatchEvent(new DragEvent("drop", drop));
    }, files);
    await page.getByRole("list", { name: "Uploads" }).getByRole("listitem").nth(20).waitFor();
    await expect.poll(() => page.getByRole("region", { name: "Past" }).innerText(), kSoon).toContain("is stored");
    await touchAll();
  });
});

describe("RACE-One", () => {
  it("shows skills, tasks, values, outcomes and a run whose texts are such", async () => {
    await send("PUT", "/documents/skills-of-others", hostileSkills);
    await page.goto(`${fixture.url}/one/`);
    await page.getByRole("link", { name: /^described0/ }).waitFor();
    await expect.poll(() => seen(), kSoon).toBeGreaterThan(kNearlyAll);
    await page.getByRole("link", { name: /^described0/ }).click();
    await expect.poll(() => page.locator("[data-skill]").count(), kSoon).toBeGreaterThan(kNearlyAll);
    await touchAll();
    await page.goto(`${fixture.url}/one/?edit=skills-of-others`);
    await page.getByRole("button", { name: /^Ready/ }).waitFor();
    await expect.poll(() => seen(), kSoon).toBeGreaterThan(kNearlyAll);
    const panel = page.getByRole("complementary", { name: "What is selected" });
    for (const at of [0, 7, 40, 90, payloads.length - 1]) {
      await page.locator(".step > .card > .card-open").nth(at).click();
      await panel.getByRole("textbox").first().waitFor();
      await pressAll(".panel summary");
      await panel.getByRole("textbox").nth(1).fill(payloads[at] ?? "");
      await touchAll();
    }
    const run = await start("skills-of-others");
    await page.getByRole("button", { name: "Run", exact: true }).click();
    await expect.poll(() => page.getByRole("status", { name: "Run status" }).innerText(), kSoon).toBe("Running");
    await rest();
    await send("POST", `/cores/${run}/stop`);
  });
});

describe("services", () => {
  /** What a display may show at once; buttons are short. */
  const short = payloads.filter((text) => Buffer.byteLength(text) <= 40);
  const buttonsOf = (i: number) => [...new Set(short.slice((i * 8) % (short.length - 8), ((i * 8) % (short.length - 8)) + 8))];

  it("have a display show texts, questions, buttons, units and images, and the expert page tells of them", async () => {
    const display = await context.newPage();
    display.setDefaultTimeout(kPatience);
    await display.goto(`${fixture.url}/display/?name=phone`);
    await display.getByRole("status", { name: "Connection" }).filter({ hasText: "Connected" }).waitFor();
    const found = new Set<string>();
    for (const [i, texts] of groups.entries()) {
      const [buttons, text] = [JSON.stringify(buttonsOf(i)), literal(texts.join("\n"))];
      const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9" onload="alert(1)"><script>alert(1)</script><foreignObject><img xmlns='http://www.w3.org/1999/xhtml' src='x' onerror='alert(1)'/></foreignObject></svg>`;
      const image = `data:image/svg+xml;base64,${Buffer.from(svg).toString("base64")}`;
      const ask = i % 2 === 0 ? `svc.display.ask(${text}, ${buttons})` : `svc.display.ask_number(${text}, 0, 1, unit=${literal((texts.find((each) => each.length <= 16) ?? "<b>").slice(0, 16))})`;
      await send("PUT", "/documents/telling", callingTask(i % 2 === 0 ? `svc.display.show_image(${literal(image)}, ${text}, ${buttons})` : `svc.display.show_text(${text}, ${buttons})`, ask));
      const id = await start("telling");
      await display.getByRole("region", { name: "Question" }).waitFor();
      if (i % 4 === 0) {
        await openRun(id);
        await page.getByRole("alert", { name: "Waiting for a person" }).waitFor();
        await touchAll();
      }
      for (const each of await shownOf(payloads, context)) found.add(each);
      await send("POST", `/cores/${id}/stop`);
      await display.getByRole("region", { name: "Question" }).waitFor({ state: "detached" });
    }
    expect(found.size).toBeGreaterThan(kNearlyAll);
    await display.close();
  });

  it("are shown with what they have done, and so is the cell", async () => {
    await page.goto(`${fixture.url}/pro/`);
    await page.getByRole("tab", { name: /Services/ }).click();
    await page.locator(".service").first().waitFor();
    await touchAll();
    await page.getByRole("tab", { name: "Cell" }).click();
    await page.getByRole("button", { name: "Parts" }).click();
    await page.getByRole("list", { name: "Parts" }).waitFor();
  });
});

describe("an address", () => {
  const keys = ["run", "at", "edit", "runs", "versions", "help", "tour", "page", "follow", "axis", "in", "sel", "why", "top", "below", "name", "embed", "token"];
  const everywhere = (text: string) => keys.map((key) => `${key}=${encodeURIComponent(text)}`).join("&");

  it("may say anything in each of its entries, on every page", async () => {
    fixture.allowError(/status of 4\d\d/);
    for (const text of [payloads[0] ?? "", "javascript:alert(1)", ...(payloadsByClass["polyglots"]?.slice(0, 2) ?? [])])
      for (const path of ["/pro/", "/display/", "/trust/", "/"]) {
        await page.goto(`${fixture.url}${path}?${everywhere(text)}#${encodeURIComponent(text)}`);
        if (path === "/") await page.waitForURL("**/pro/");
        await rest();
        await page.evaluate((hash) => void (location.hash = hash), text);
      }
  });

  it("may change to any of the texts, by the browser's Back and Forward", async () => {
    for (const path of ["/pro/?edit=described0", "/one/", "/one/?edit=guarded", "/one/?edit=draft#run", "/display/?name=phone", "/trust/"]) {
      await page.goto(`${fixture.url}${path}`);
      await rest();
      // Of the pages, one reads its whole address again.
      await page.evaluate(async ([texts, all]) => {
        for (const [i, text] of texts.entries()) {
          const query = i % 8 === 0 ? all.map((key) => [key, text]) : [["edit", "described0"], [all[i % all.length] ?? "in", text], ["sel", text], ["in", text]];
          history.pushState(null, "", `?${new URLSearchParams(query).toString()}#${encodeURIComponent(text)}`);
          dispatchEvent(new PopStateEvent("popstate"));
          dispatchEvent(new HashChangeEvent("hashchange"));
          await new Promise((resolve) => setTimeout(resolve, 4));
        }
      }, [path.startsWith("/pro/") ? payloads : payloads.filter((_, i) => i % 4 === 0), keys] as const);
      await rest();
    }
  });
});

describe("a server with accounts", () => {
  const kPassword = "correct horse battery";
  let closed: Fixture;
  beforeAll(async () => {
    closed = await openPrepared((data) => execFileSync(binary, ["account", "add", "ada", "--role", "admin", "--data", data], { input: `${kPassword}\n` }));
    closed.allowError(/status of 4\d\d/);
  });
  afterAll(() => closed.close());

  it("says who cannot log in, which names no account can have, and who may do what", async () => {
    const own = await closed.openContext({ bypassCSP: true });
    const { found } = await watchScripts(own, closed.url);
    const cover = await own.newPage();
    cover.setDefaultTimeout(kPatience);
    const logIn = async (name: string, password: string) => {
      await cover.getByLabel("Name", { exact: true }).fill(name);
      await cover.getByLabel("Password", { exact: true }).fill(password);
      await cover.keyboard.press("Enter");
    };
    for (const path of ["/display/?name=phone", "/pro/"]) {
      await cover.goto(`${closed.url}${path}`);
      await logIn(payloads[0] ?? "", payloads[1] ?? "");
      await cover.getByRole("alert").first().waitFor();
    }
    await logIn("ada", kPassword);
    await cover.getByRole("button", { name: "ada admin" }).click();
    await cover.getByRole("menuitem", { name: "Accounts…" }).click();
    const panel = cover.getByRole("dialog", { name: "Accounts" });
    await panel.evaluate((dialog) => dialog.querySelectorAll("input").forEach((field) => ["pattern", "maxlength"].forEach((name) => field.removeAttribute(name))));
    const add = panel.getByRole("button", { name: "Add" });
    for (const text of [...payloadsByClass["names"] ?? [], ...payloadsByClass["polyglots"] ?? []]) {
      await panel.getByLabel("Name of the account").fill(text);
      await panel.getByLabel("Password of the account").fill(`${text} and more than this`);
      await add.click();
      await expect.poll(() => add.isEnabled(), kSoon).toBe(true);
    }
    await panel.getByRole("alert").waitFor();
    await panel.getByRole("listitem", { name: "constructor" }).waitFor();
    expect(found()).toEqual([]);
    await own.close();
  });
});

describe("with the policy that browsers enforce", () => {
  it("it refuses nothing, as there is nothing to refuse", async () => {
    // The page on trust asks for an authority that this server does not have.
    fixture.allowError(/status of 404 .*authority/);
    const guarded = await fixture.openContext({ viewport: { width: 1366, height: 768 } });
    const { found } = await watchScripts(guarded, fixture.url);
    const strict = await guarded.newPage();
    strict.setDefaultTimeout(kPatience);
    await send("PUT", "/documents/guarded", hostileTask("pass", 3600));
    const { id } = await send("POST", "/cores", { document: "guarded" });
    for (const address of ["/pro/", "/pro/?edit=guarded", "/pro/?edit=draft", `/pro/?run=${id}`, "/display/?name=phone", "/trust/"]) {
      await strict.goto(`${fixture.url}${address}`);
      if (/pro.*(=guarded|run=)/.test(address)) {
        await settled(strict);
        for (const path of ["Root/S0", "Root/S7"]) await strict.getByRole("treeitem", { name: path, exact: true }).locator(".tree-name").click();
      }
      await strict.waitForTimeout(500);
    }
    expect(found()).toEqual([]);
    await guarded.close();
  });
});
