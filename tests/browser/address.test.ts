// The place in the address: the state that is entered, the selection and the panel below are in it, so links and the browser's Back lead there.
import type { Page } from "playwright-core";
import { editPage } from "./editPage";
import { openFixture, settled, type Fixture } from "./fixture";

let fixture: Fixture;
let page: Page;
const kDeep = {
  rcm: 1,
  root: {
    state: "Root", first: "Pick",
    children: [
      { state: "Pick", first: "Reach", children: [{ state: "Reach", first: "Slow", children: [{ state: "Slow" }], ports: [{ name: "done", when: "True" }] }] },
      { state: "Place" },
    ],
  },
  library: [{ state: "Look", first: "Turn", children: [{ state: "Turn" }] }],
};
/** Makes forty macro steps a second. */
const kTicking = {
  rcm: 1,
  root: {
    state: "Root", first: "Tick",
    children: [
      { state: "Tick", ports: [{ name: "next", after: "0.025", to: "Tock" }] },
      { state: "Tock", ports: [{ name: "next", after: "0.025", to: "Tick" }] },
    ],
  },
};
beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
  await fixture.send("PUT", "/documents/deep", kDeep);
  await fixture.send("PUT", "/documents/ticking", kTicking);
});
afterAll(() => fixture.close());

const query = (of = page) => Object.fromEntries(new URL(of.url()).searchParams);
const reload = async (address: string): Promise<Page> => {
  const other = await fixture.openPage({ width: 1600, height: 1000 });
  await other.goto(address);
  await settled(other);
  return other;
};

describe("a run", () => {
  it("has state, selection and panel in its address, which another page opens", async () => {
    const { id } = (await fixture.send("POST", "/cores", { document: "deep" })) as { readonly id: string };
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(page);
    expect(query()).toEqual({ run: id });
    await page.locator('.canvas [data-path="Root/Pick"]').first().dblclick({ position: { x: 20, y: 8 }, modifiers: ["Control"] });
    await expect.poll(() => query()["in"]).toBe("Root/Pick");
    await settled(page);
    await page.getByRole("button", { name: "Port Root/Pick/Reach.done", exact: true }).click();
    await page.getByRole("tab", { name: "Time line" }).click();
    await expect.poll(() => query()).toEqual({ run: id, in: "Root/Pick", sel: "Root/Pick/Reach.done", below: "timeline" });
    expect(page.url()).toContain("sel=Root/Pick/Reach.done");
    const other = await reload(page.url());
    await other.locator('.port.is-selected[aria-label="Port Root/Pick/Reach.done"]').waitFor();
    expect(await other.locator('.canvas [data-path="Root/Place"]').count()).toBe(0);
    await other.getByRole("tab", { name: "Time line", selected: true }).waitFor();
    await expect.poll(() => query(other)).toEqual(query());
    await other.close();
  });

  it("goes back through the states that were entered, not through each selection, and over pages", async () => {
    const at = () => [query()["in"], query()["sel"], query()["page"]];
    await page.getByRole("tab", { name: "Services" }).click();
    await page.getByRole("tab", { name: "Task" }).click();
    await settled(page);
    await page.goBack();
    await page.goBack();
    await settled(page);
    await expect.poll(at).toEqual(["Root/Pick", "Root/Pick/Reach.done", undefined]);
    await page.goBack();
    await page.locator('.canvas [data-path="Root/Place"]').first().waitFor();
    await expect.poll(at).toEqual([undefined, undefined, undefined]);
    await page.goForward();
    await page.locator('.port.is-selected[aria-label="Port Root/Pick/Reach.done"]').waitFor();
    await expect.poll(() => at()).toEqual(["Root/Pick", "Root/Pick/Reach.done", undefined]);
  });
});

describe("a run that goes on", () => {
  it("has what is selected in its address within a moment, however many steps it makes", async () => {
    const { id } = (await fixture.send("POST", "/cores", { document: "ticking" })) as { readonly id: string };
    await fixture.send("POST", `/cores/${id}/start`);
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(page);
    await page.getByRole("treeitem", { name: "Root/Tock" }).click();
    await expect.poll(() => query()["sel"]).toBe("Root/Tock");
    // At once, where another entry of the history follows.
    await page.getByRole("treeitem", { name: "Root/Tick" }).click();
    await page.getByRole("tab", { name: "Services" }).click();
    expect(await page.evaluate(() => new URL(location.href).searchParams.get("sel"))).toBe("Root/Tick");
    await page.goBack();
    await page.getByRole("treeitem", { name: "Root/Tick", selected: true }).waitFor();
    await fixture.send("POST", `/cores/${id}/stop`);
  });

  it("stays in the state that was entered when an edit of its document renames that", async () => {
    const { id } = (await fixture.send("POST", "/cores", { document: "deep" })) as { readonly id: string };
    await fixture.send("PUT", `/cores/${id}/live`, { live: true });
    await page.goto(`${fixture.url}/pro/?run=${id}&in=Root/Pick`);
    await page.locator('.canvas [data-path="Root/Pick/Reach"]').first().waitFor();
    const { revision, document } = (await fixture.send("GET", "/documents/deep")) as { readonly revision: number; readonly document: { readonly root: { readonly children: readonly { readonly meta: { readonly id: string } }[] } } };
    const [pick] = document.root.children;
    const edit = (at: number, compound: object) => fixture.send("POST", "/documents/deep/edits", { compound, author: "Ann", revision: at });
    await edit(revision, { kind: "rename", id: pick?.meta.id ?? "", name: "Fetch" });
    await page.locator('.canvas [data-path="Root/Fetch/Reach"]').first().waitFor();
    await expect.poll(() => query()["in"]).toBe("Root/Fetch");
    await page.getByRole("navigation", { name: "Breadcrumb" }).getByRole("button", { name: "Fetch" }).waitFor();
    await edit(revision + 1, { kind: "rename", id: pick?.meta.id ?? "", name: "Pick" });
    await page.locator('.canvas [data-path="Root/Pick/Reach"]').first().waitFor();
    await page.getByRole("navigation", { name: "Breadcrumb" }).getByRole("button", { name: "Root" }).click();
    await settled(page);
  });
});

describe("a document", () => {
  it("is a page of its own: Back leads to the run from which it was opened, and Forward to the document", async () => {
    const { id } = (await fixture.send("POST", "/cores", { document: "deep" })) as { readonly id: string };
    await page.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(page);
    await page.getByRole("button", { name: "Edit", exact: true }).first().click();
    await expect.poll(() => query()["edit"]).toBeTruthy();
    const edited = query()["edit"];
    await page.goBack();
    await page.getByRole("tab", { name: "Task", selected: true }).waitFor();
    await expect.poll(() => [query()["run"], query()["edit"]]).toEqual([id, undefined]);
    await page.goForward();
    await page.getByRole("tab", { name: "Edit", selected: true }).waitFor();
    await expect.poll(() => query()["edit"]).toBe(edited);
  });

  it("keeps its place when the state is renamed, and a link leads there", async () => {
    const edit = editPage(fixture);
    await page.goto(`${fixture.url}/pro/?edit=deep&in=Root/Pick&sel=Root/Pick/Reach`);
    await settled(page);
    await page.getByRole("complementary", { name: "Properties" }).locator(".form-title").getByRole("textbox").fill("Approach");
    await page.keyboard.press("Enter");
    await expect.poll(() => query()["sel"]).toBe("Root/Pick/Approach");
    await settled(page);
    await edit.node("Root/Pick/Approach").dblclick({ position: { x: 20, y: 8 }, modifiers: ["Control"] });
    await expect.poll(() => query()["in"]).toBe("Root/Pick/Approach");
    const other = await reload(page.url());
    await other.locator('#edit-canvas [data-path="Root/Pick/Approach/Slow"]').waitFor();
    expect(await other.locator('#edit-canvas [data-path="Root/Pick"]').count()).toBe(0);
    await other.close();
    await page.goBack();
    await expect.poll(() => query()["in"]).toBe("Root/Pick");
  });

  it("has the state of the library that is edited in its address", async () => {
    await page.locator("[data-library] .palette-item").first().click();
    await page.locator('#edit-canvas [data-path="Look/Turn"]').waitFor();
    await expect.poll(() => query()["top"]).toBeTruthy();
    const other = await reload(page.url());
    await other.locator('#edit-canvas [data-path="Look/Turn"]').waitFor();
    await other.close();
    await page.goBack();
    await page.locator('#edit-canvas [data-path^="Root/"]').first().waitFor();
  });
});
