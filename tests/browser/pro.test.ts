// The expert page on the real server, with the demo task Pick and its cell.
import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { activations, noteActivations } from "./activations";
import { expectedCard, expectedLines, pickRow, proofCount, reachNode, reachProof, shownCard, shownLines, showStep, type RawNode, type RawStep } from "./proofText";
import { binary, openFixture, type Fixture } from "./fixture";
import { letMove } from "./hands";
import { kSoon } from "./patience";

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
});
afterAll(() => fixture.close());

/** Loads the document `pick` as a new run, and gives its id. */
async function load(): Promise<string> {
  const runs = page.getByRole("combobox", { name: "Watched run" });
  const before = await runs.inputValue();
  await letMove(page, "pick");
  await page.getByRole("combobox", { name: "Document" }).selectOption("pick");
  await page.getByRole("button", { name: "Load" }).click();
  await expect.poll(() => runs.inputValue()).not.toBe(before);
  await page.getByRole("group", { name: "State Pick/Release" }).waitFor();
  return runs.inputValue();
}

const status = () => page.getByRole("status", { name: "Run status" });
const ended = () => expect.poll(() => status().innerText(), { timeout: 90_000 }).toMatch(/Ended|Faulted|Stopped/);

/** `race derive` of the run as the server exports it. */
async function derive(id: string): Promise<readonly RawStep[]> {
  const folder = mkdtempSync(join(tmpdir(), "race-derive-"));
  const get = async (path: string): Promise<unknown> => (await fetch(`${fixture.url}/api/v1/cores/${id}/${path}`)).json();
  const native = (await get("native")) as { readonly document: unknown };
  writeFileSync(join(folder, "model.json"), JSON.stringify(native.document));
  writeFileSync(join(folder, "script.json"), JSON.stringify(await get("script")));
  const text = execFileSync(binary, ["derive", join(folder, "model.json"), join(folder, "script.json")], { maxBuffer: 1 << 28 }).toString();
  return (JSON.parse(text) as { readonly steps: readonly RawStep[] }).steps;
}

/** The nodes of a proof in the order of their rows. */
const preorder = (node: RawNode): readonly RawNode[] => [node, ...node.premises.flatMap(preorder)];

describe("RACE Pro", () => {
  it("leads from the address of the server to the page", async () => {
    // Browsers may ask for it before they have read a page.
    expect((await page.request.get(`${fixture.url}/favicon.ico`)).headers()["content-type"]).toBe("image/x-icon");
    await page.goto(fixture.url);
    await page.waitForURL("**/pro/");
    await expect.poll(() => page.getByText("Connected").isVisible()).toBe(true);
  });

  it("shows the states of Pick turn green in order, until it ends at success", async () => {
    await load();
    await noteActivations(page);
    await page.getByRole("button", { name: "Start" }).click();
    await expect.poll(() => activations(page), kSoon).toContain("Pick/Approach");
    await fixture.screenshot("running");
    await ended();
    await expect.poll(() => status().innerText()).toContain("Ended: success");
    const leaves = (await activations(page)).filter((path) => /^Pick\/[A-Za-z]+$/.test(path));
    // One that is left within the frame in which it was entered is not seen: those that only wait for a call may be among them.
    const order = ["Release", "GetPose", "Approach", "Grasp", "Retreat", "CheckPart"].map((name) => `Pick/${name}`);
    expect(leaves).toEqual(order.filter((path) => leaves.includes(path)));
    expect(leaves).toEqual(expect.arrayContaining(["Pick/Approach", "Pick/Retreat"]));
    await fixture.screenshot("ended");
  });

  it("opens the derivation of a micro step and finds PTrans1 (3.28) in it", async () => {
    await showStep(page, 1);
    const inference = await reachNode(page, /^PTrans1 \(3\.28\) Pick/);
    await inference.locator(".proof-row").first().click();
    const card = page.getByRole("region", { name: "Inference" });
    await expect.poll(() => card.innerText()).toContain("3.28");
    await expect.poll(() => card.getByRole("figure").innerText()).toContain("Pick′, Δ′");
    await fixture.screenshot("derivation");
  });

  it("shows every node of the run's derivation whole, as `race derive` gives it for the exported script", async () => {
    const id = await page.getByRole("combobox", { name: "Watched run" }).inputValue();
    const derived = await derive(id);
    const steps = page.getByRole("list", { name: "Macro steps" }).getByRole("button");
    await expect.poll(() => steps.count()).toBe(derived.length);
    const carded = new Set<string>();
    for (const [i, step] of derived.entries()) {
      await showStep(page, i);
      await expect.poll(() => proofCount(page)).toBe(step.micro.length);
      for (const [m, micro] of step.micro.entries()) {
        const where = `step ${i + 1}, micro step ${m + 1}`;
        const proof = await reachProof(page, m);
        await proof.getByRole("button", { name: "Unfold all" }).click();
        // Rows come into the page some frames after they are scrolled to.
        await expect.poll(async () => (await shownLines(proof)).join("\n"), { message: where }).toBe(expectedLines(micro).join("\n"));
        // One card for each kind of node: a rule with the fields that it has.
        for (const [n, node] of preorder(micro).entries()) {
          const kind = `${node.rule} ${Object.keys(node).join(" ")}`;
          if (carded.has(kind)) continue;
          carded.add(kind);
          await pickRow(proof, n);
          await expect.poll(() => shownCard(page.getByRole("region", { name: "Inference" })), { message: `${where}, node ${n}` }).toEqual(expectedCard(node));
        }
      }
    }
    // The run holds what the comparison is about: values, refinements, calls, several premises.
    const kinds = [...carded].join("\n");
    for (const expected of [/^Cond .*value/m, /refinement/, /^FuncSC .*args/m, /^PTrans1 /m, /^Resolve .*value/m]) expect(kinds).toMatch(expected);
  }, 240_000);

  it("steps a run that was not started, and says why a port does not fire", async () => {
    await load();
    await page.getByRole("button", { name: "Macro step" }).click();
    await expect.poll(() => page.getByRole("treeitem", { name: "Pick/Release", exact: true }).getAttribute("data-active")).toBe("true");
    await page.getByRole("button", { name: "Port Pick/Release.success", exact: true }).click();
    const why = page.getByRole("region", { name: "Why" });
    await expect.poll(() => why.innerText()).toMatch(/svc\.gripper\.release\.result/);
    await fixture.screenshot("why");
  });

  it("fires the port once what the explanation names has changed", async () => {
    const why = page.getByRole("region", { name: "Why" });
    await expect.poll(() => why.locator("[data-blocks=true] code").allInnerTexts()).toEqual(["svc.gripper.release.result"]);
    await page.getByRole("button", { name: "Macro step" }).click();
    await expect.poll(() => page.getByRole("treeitem", { name: "Pick/GetPose", exact: true }).getAttribute("data-active"), kSoon).toBe("true");
  });

  it("runs until a state is entered, and stops on demand", async () => {
    await page.getByRole("button", { name: "Select Pick/Grasp" }).click();
    await page.getByRole("button", { name: "Run until entered" }).click();
    const grasp = page.getByRole("treeitem", { name: "Pick/Grasp", exact: true });
    await expect.poll(() => grasp.getAttribute("data-active"), { timeout: 60_000 }).toBe("true");
    await expect.poll(() => status().innerText()).toContain("Paused");
    await page.keyboard.press("F8");
    await expect.poll(() => status().innerText()).toContain("Stopped");
  });

  it("says why a port has fired, with the atoms as they were then", async () => {
    await page.getByRole("button", { name: "Port Pick/GetPose.success", exact: true }).click();
    const fired = page.getByRole("region", { name: "Why it fired" });
    await expect.poll(() => fired.innerText()).toMatch(/Fired in macro step \d+, micro step \d+/);
    await expect.poll(() => fired.getByRole("listitem").allInnerTexts()).toEqual([expect.stringMatching(/available\(res\.pose\)\s+true/)]);
    await fixture.screenshot("fired");
  });

  it("writes everything so that it can be read, and shows the whole task on demand", async () => {
    await page.getByRole("button", { name: "Everything" }).click();
    const canvas = page.locator(".canvas");
    const code = page.locator('[data-path="Pick/Release"] .state-text');
    await expect.poll(() => code.innerText()).toContain("svc.gripper.release()");
    await expect.poll(() => canvas.getAttribute("data-zoom")).toBe("near");
    await expect.poll(() => code.isVisible()).toBe(true);
    await fixture.screenshot("everything");
    const root = page.getByRole("group", { name: "State Pick", exact: true });
    await page.keyboard.press("Control+Space");
    await expect
      .poll(async () => {
        const [drawing, frame] = [await root.boundingBox(), await canvas.boundingBox()];
        return drawing !== null && frame !== null && drawing.y >= frame.y && drawing.y + drawing.height <= frame.y + frame.height;
      })
      .toBe(true);
    await page.getByRole("button", { name: "Names" }).click();
  });

  it("finds a state by its code and jumps to it", async () => {
    await page.getByRole("searchbox", { name: "Search the model" }).fill("gripper.grasp");
    await page.getByRole("list", { name: "Search results" }).getByRole("button").first().click();
    await expect.poll(() => page.getByRole("complementary", { name: "Properties" }).innerText()).toContain("Grasp");
    await page.getByRole("searchbox", { name: "Search the model" }).fill("");
  });

  it("draws every service with its present state", async () => {
    await page.getByRole("tab", { name: /Services/ }).click();
    for (const key of ["robot", "gripper", "db", "timer"]) {
      const service = page.getByRole("article", { name: `Service ${key}` });
      await service.getByRole("img", { name: /, now in \w+/ }).waitFor();
      await expect.poll(() => service.locator(".rsm-state.is-active").count()).toBe(1);
    }
    await fixture.screenshot("services");
  });

  it("shows the cell in 3D", async () => {
    await page.getByRole("tab", { name: "Cell" }).click();
    await expect.poll(() => page.locator(".cell-clock").innerText(), kSoon).toMatch(/cell time \d/);
    await fixture.screenshot("cell");
  });

  it("needs no sideways scrolling on a narrow screen", async () => {
    await page.getByRole("tab", { name: "Task" }).click();
    await page.setViewportSize({ width: 412, height: 915 });
    await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(412);
    await fixture.screenshot("narrow");
    await page.setViewportSize({ width: 1600, height: 1000 });
  });

  it("watches the newest run from the first moment, however long the server has been up", async () => {
    await load();
    const id = await load();
    const second = await fixture.openPage();
    await expect.poll(() => second.getByRole("combobox", { name: "Watched run" }).inputValue()).toBe(id);
    await second.close();
  });

  it("shows a lost connection, reconnects, and starts a new run", async () => {
    await fixture.kill();
    await expect.poll(() => page.getByText("Connection lost").isVisible()).toBe(true);
    await fixture.screenshot("gone");
    await fixture.restart();
    await expect.poll(() => page.getByText("Connected").isVisible(), kSoon).toBe(true);
    // The run that it watched was not over: it is there again.
    await expect.poll(() => page.getByRole("combobox", { name: "Watched run" }).inputValue()).not.toBe("");
    await load();
    // Release ends in a fifth of a second, when the gripper is half open: too short to observe.
    await noteActivations(page);
    await page.getByRole("button", { name: "Start" }).click();
    await expect.poll(() => activations(page)).toContain("Pick/Release");
    await page.keyboard.press("F8");
    await expect.poll(() => status().innerText()).toContain("Stopped");
  });
});
