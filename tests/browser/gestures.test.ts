// What the mouse does on the drawing that is edited.
import { editPage, middle } from "./editPage";
import { openFixture, settled, type Fixture } from "./fixture";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
});
afterAll(() => fixture.close());

const at = (selector: string) => middle(fixture.page, `#edit-canvas ${selector}`);

/** Presses on one place and moves to the other; the button stays down. */
async function dragTo(from: { readonly x: number; readonly y: number }, to: { readonly x: number; readonly y: number }): Promise<void> {
  await fixture.page.mouse.move(from.x, from.y);
  await fixture.page.mouse.down();
  await fixture.page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 4 });
  await fixture.page.mouse.move(to.x, to.y, { steps: 4 });
}

describe("a drag from a port", () => {
  it("leads it to the sibling on which it ends; others are dimmed", async () => {
    const { open, state } = editPage(fixture);
    await open("wire");
    await dragTo(await at('[data-address="Root/B.done"]'), await at('[data-path="Root/Both"]'));
    await fixture.screenshot("edit-wire");
    await fixture.page.mouse.up();
    await expect.poll(async () => (await state("wire", "B"))?.ports?.[0]?.to).toBe("Both");
  });

  it("asks on the background, and makes a state there", async () => {
    const { open, children, state, canvas } = editPage(fixture);
    await open("background");
    const box = await canvas.boundingBox();
    const background = { x: (box?.x ?? 0) + (box?.width ?? 0) / 2, y: (box?.y ?? 0) + (box?.height ?? 0) - 40 };
    await dragTo(await at('[data-address="Root/B.done"]'), background);
    await fixture.page.mouse.up();
    await fixture.page.getByRole("menuitem", { name: "New state here" }).click();
    await expect.poll(() => children("background")).toEqual(["A", "B", "State", "C", "Both"]);
    await expect.poll(async () => (await state("background", "B"))?.ports?.[0]?.to).toBe("State");
  });

  it.each(["Esc", "pointercancel", "blur"])("is given up by %s", async (way) => {
    const { open, state, node } = editPage(fixture);
    await open("aborted");
    await dragTo(await at('[data-address="Root/B.done"]'), await at('[data-path="Root/Both"]'));
    await fixture.page.locator(".drag-line").waitFor({ state: "attached" });
    if (way === "Esc") await fixture.page.keyboard.press("Escape");
    else if (way === "blur") await fixture.page.evaluate(() => dispatchEvent(new Event("blur")));
    else await fixture.page.evaluate(() => dispatchEvent(new PointerEvent("pointercancel", { pointerId: 1 })));
    await expect.poll(() => fixture.page.locator(".drag-line").count()).toBe(0);
    await fixture.page.mouse.up();
    await node("Root/B").click({ position: { x: 20, y: 8 } });
    expect((await state("aborted", "B"))?.ports?.[0]?.to).toBeUndefined();
  });

  it("leads a barrier to one more state", async () => {
    const { open, state } = editPage(fixture);
    await open("barrier");
    await dragTo(await at('[data-path="Root/Both"]'), await at('[data-path="Root/A"] .state-name'));
    await fixture.page.mouse.up();
    await expect.poll(async () => (await state("barrier", "Both"))?.to).toEqual(["C", "A"]);
  });
});

describe("a row of the tree", () => {
  const row = (path: string) => fixture.page.locator(`[role="tree"] [data-path="${path}"]`);
  /** A part of a row: 0 is its upper edge, 1 its lower one. */
  const part = async (path: string, share: number) => {
    const box = await row(path).boundingBox();
    if (box === null) throw new Error(`${path} has no row`);
    return { x: box.x + 90, y: box.y + share * box.height };
  };
  const drag = async (path: string, to: { readonly x: number; readonly y: number }) => {
    await dragTo(await part(path, 0.5), to);
    await fixture.screenshot("edit-tree-drag");
    await fixture.page.mouse.up();
  };

  it("is dragged into another state, and between its siblings", async () => {
    const { open, children, state } = editPage(fixture);
    await open("tree");
    await drag("Root/B", await part("Root/C", 0.5));
    await expect.poll(async () => (await state("tree", "C"))?.children?.map((child) => child.state)).toEqual(["D", "B"]);
    await expect.poll(async () => (await state("tree", "A"))?.ports?.[0]?.to).toBeUndefined();
    await row("Root/C/B").waitFor();
    await drag("Root/C/B", await part("Root/A", 0.1));
    await expect.poll(() => children("tree")).toEqual(["B", "A", "C", "Both"]);
    await drag("Root/Both", await part("Root/A", 0.95));
    await expect.poll(() => children("tree")).toEqual(["B", "A", "Both", "C"]);
  });

  it("says what cannot be, and then changes nothing", async () => {
    const { open, children } = editPage(fixture);
    await open("tree-refused");
    await dragTo(await part("Root/C", 0.5), await part("Root/C/D", 0.9));
    await fixture.page.getByText("a state does not move into itself").waitFor();
    await fixture.page.mouse.up();
    expect(await children("tree-refused")).toEqual(["A", "B", "C", "Both"]);
  });
});

describe("a drawing that grows", () => {
  it("is seen as a whole, until it has been moved by hand", async () => {
    const { open, select, canvas, node } = editPage(fixture);
    const isSeen = async () => {
      await settled(fixture.page);
      const [outer, box] = [await canvas.boundingBox(), await node("Root").boundingBox()];
      return outer !== null && box !== null && box.x >= outer.x && box.y >= outer.y && box.x + box.width <= outer.x + outer.width && box.y + box.height <= outer.y + outer.height;
    };
    const grow = async (by: number) => {
      for (let i = 0; i < by; ++i) await fixture.page.keyboard.press("Alt+s");
      await node(`Root/State${by}`).waitFor();
    };
    await open("grows", { rcm: 1, root: { state: "Root", first: "A", children: [{ state: "A" }] } });
    await select("Root/A");
    await grow(9);
    await expect.poll(isSeen).toBe(true);
    await open("grows-moved", { rcm: 1, root: { state: "Root", first: "A", children: [{ state: "A" }] } });
    await select("Root/A");
    await fixture.page.keyboard.press("Control+=");
    await grow(9);
    await expect.poll(isSeen).toBe(false);
  });
});

describe("selecting", () => {
  it("takes several by Ctrl and Shift clicks, and by a frame", async () => {
    const { open, select, node, canvas } = editPage(fixture);
    await open("select");
    await select("Root/A");
    for (const modifier of ["Control", "Shift"] as const) await node(modifier === "Control" ? "Root/B" : "Root/C").click({ position: { x: 20, y: 8 }, modifiers: [modifier] });
    await expect.poll(() => canvas.locator(".state.is-selected").count()).toBe(3);
    await fixture.page.keyboard.press("Escape");
    const box = await node("Root").boundingBox();
    if (box === null) throw new Error("Root is not drawn");
    await fixture.page.keyboard.down("Shift");
    await dragTo({ x: box.x - 10, y: box.y - 10 }, { x: box.x + box.width + 30, y: box.y + box.height + 30 });
    await fixture.screenshot("edit-band");
    await fixture.page.mouse.up();
    await fixture.page.keyboard.up("Shift");
    await expect.poll(() => canvas.locator(".is-selected").getAttribute("aria-label")).toBe("State Root");
  });

  it("enters with Ctrl and a double click, and opens the state editor without", async () => {
    const { open, node } = editPage(fixture);
    await open("enter");
    await node("Root/C").dblclick({ position: { x: 20, y: 8 } });
    const editor = fixture.page.getByRole("region", { name: "State editor: C" });
    await editor.waitFor();
    await fixture.page.keyboard.press("Escape");
    await editor.waitFor({ state: "detached" });
    expect(await fixture.page.getByRole("navigation", { name: "Breadcrumb" }).innerText()).not.toContain("C");
    await settled(fixture.page);
    await node("Root/C").dblclick({ position: { x: 20, y: 8 }, modifiers: ["Control"] });
    await expect.poll(() => fixture.page.getByRole("navigation", { name: "Breadcrumb" }).innerText()).toContain("C");
    await settled(fixture.page);
  });
});
