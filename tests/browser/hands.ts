// A model as a user builds it: by mouse, where keys only write texts, and by keyboard alone.
import type { Locator, Page } from "playwright-core";
import { itemsOf, type ExactObject } from "../../web/shared/edit/clipboard/json";
import { writeExact, type ExactJson } from "../../web/shared/edit/exact";
import { write } from "./editPage";
import { settled } from "./fixture";

const textOf = (value: ExactJson | undefined): string => (typeof value === "string" ? value : "");
/** A type is written as a word, or as JSON. */
const typeText = (type: ExactJson): string => (typeof type === "string" ? type : writeExact(type));
const has = (each: ExactObject, field: string): boolean => Object.hasOwn(each, field);

const kLists = [["parameters", "Parameters", "parameter"], ["results", "Results", "result"], ["variables", "Variables", "variable"]] as const;
const kAbout = [["type", "Type"], ["unit", "Unit"], ["doc", "Description"]] as const;
const kMore = "Type, unit and description";

const objects = (value: ExactJson | undefined): readonly ExactObject[] => itemsOf(value) as readonly ExactObject[];

/** Presses on one place and moves to the other; the button stays down. */
export async function dragTo(page: Page, from: { readonly x: number; readonly y: number }, to: { readonly x: number; readonly y: number }): Promise<void> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 4 });
  await page.mouse.move(to.x, to.y, { steps: 4 });
}

async function middleOf(part: Locator): Promise<{ readonly x: number; readonly y: number }> {
  const box = await part.boundingBox();
  if (box === null) throw new Error(`${String(part)} is not on the screen`);
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

export function mouse(page: Page) {
  const form = page.getByRole("complementary", { name: "Properties" });
  const canvas = page.locator("#edit-canvas");
  const rows = (list: string) => form.getByRole("region", { name: new RegExp(`^${list}`) }).getByRole("listitem");

  /** Writes a text; the field is left by a click on what says what the form is of. */
  const put = async (field: Locator, text: string): Promise<void> => {
    await write(field, text);
    await form.locator(".form-head small").first().click({ position: { x: 2, y: 2 } });
  };
  const field = (within: Locator, name: string) => within.getByLabel(name, { exact: true });
  const addRow = async (list: string, one: string): Promise<Locator> => {
    const count = await rows(list).count();
    await form.getByRole("button", { name: `Add ${one}`, exact: true }).click();
    await rows(list).nth(count).waitFor();
    return rows(list).nth(count);
  };
  const datum = async (row: Locator, each: ExactObject): Promise<void> => {
    await put(field(row, "Name"), textOf(each["name"]));
    if (has(each, "from")) {
      await row.getByRole("button", { name: "Constant: make it an expression" }).click();
      await put(field(row, "Expression of the parent"), textOf(each["from"]));
    }
    for (const [key, name] of [["value", "Constant"], ["initial", "Initial value"]] as const) if (has(each, key)) await put(field(row, name), writeExact(each[key]));
    if (kAbout.some(([key]) => has(each, key))) await row.getByRole("button", { name: kMore }).click();
    for (const [key, name] of kAbout) if (has(each, key)) await put(field(row, name), typeText(each[key] ?? null));
  };
  return {
    form, canvas, put, rows,
    rename: (name: string) => put(form.locator(".form-title").getByRole("textbox"), name),
    /** Writes what a state has besides its name, what is in it and where its ports lead. */
    fill: async (state: ExactObject): Promise<void> => {
      if (has(state, "doc")) await put(form.getByRole("textbox", { name: "Description" }).first(), textOf(state["doc"]));
      for (const [key, list, one] of kLists) for (const each of objects(state[key])) await datum(await addRow(list, one), each);
      for (const [key, name] of [["entry", "Entry"], ["exit", "Exit"]] as const) if (has(state, key)) await put(field(form, name), textOf(state[key]));
      for (const each of objects(state["actions"])) {
        const row = await addRow("Actions", "action");
        await put(field(row, "Condition"), textOf(each["when"]));
        await put(field(row, "Function"), textOf(each["do"]));
      }
      for (const each of objects(state["ports"])) {
        const row = await addRow("Ports", "port");
        await put(field(row, "Name"), textOf(each["name"]));
        await put(field(row, "Condition"), textOf(each["when"]));
      }
    },
    /** Drags something of the left panel into the drawing, right of the middle by `by` [px]. */
    drop: async (what: string, by: number): Promise<void> => {
      await settled(page);
      const [from, to] = [await middleOf(page.getByRole("button", { name: new RegExp(`^${what}( |$)`) }).and(page.locator(".palette-item"))), await middleOf(canvas)];
      await dragTo(page, from, { x: to.x + by, y: to.y });
      await page.mouse.up();
    },
    /** Leads a port to a state by a line. */
    lead: async (port: string, to: string): Promise<void> => {
      await settled(page);
      await dragTo(page, await middleOf(canvas.locator(`[data-address="${port}"]`)), await middleOf(canvas.locator(`[data-path="${to}"]`)));
      await page.mouse.up();
    },
  };
}

/** What is heard of the element with the focus. */
export const heard = (page: Page): Promise<string> =>
  page.evaluate(() => {
    const at = document.activeElement;
    const labels = at instanceof HTMLInputElement || at instanceof HTMLSelectElement || at instanceof HTMLTextAreaElement ? at.labels : null;
    return at?.getAttribute("aria-label") ?? labels?.[0]?.textContent ?? at?.textContent ?? "";
  });

export function keyboard(page: Page) {
  const keys = async (...all: readonly string[]): Promise<void> => {
    for (const key of all) await page.keyboard.press(key);
  };
  /** Goes on by Tab, or back, to what is heard as `name`, or as that and something more. */
  const go = async (name: string, key: "Tab" | "Shift+Tab" = "Tab"): Promise<void> => {
    const passed: string[] = [];
    while (!`${passed.at(-1) ?? ""} `.startsWith(`${name} `)) {
      if (passed.length > 120) throw new Error(`${name} is not reached by ${key}: ${passed.slice(0, 40).join(" | ")}`);
      await keys(key);
      passed.push(await heard(page));
    }
  };
  /** Writes over a text of one line; Enter would add a row if it is there already. */
  const line = async (text: string): Promise<void> => {
    await keys("Control+A");
    await page.keyboard.type(text);
    await keys("Control+Enter");
  };
  /** Types code as one types it: lines are indented by the editor, Backspace takes one indent. */
  const code = async (text: string): Promise<void> => {
    await keys("Control+A", "Delete");
    let [indent, before] = [0, ""];
    for (const [i, each] of text.split("\n").entries()) {
      const wanted = /^ */.exec(each)?.[0].length ?? 0;
      if (i > 0) {
        await keys("Enter");
        indent += before.endsWith(":") ? 4 : 0;
        for (; indent > wanted; indent -= 4) await keys("Backspace");
      }
      before = each.trim();
      await page.keyboard.type(before);
    }
    await keys("Control+Enter");
  };
  const datum = async (each: ExactObject): Promise<void> => {
    await line(textOf(each["name"]));
    if (has(each, "from")) {
      await go("Constant: make it an expression");
      await keys("Enter");
      await go("Expression of the parent");
      await line(textOf(each["from"]));
    }
    for (const [key, name] of [["value", "Constant"], ["initial", "Initial value"]] as const)
      if (has(each, key)) {
        await go(name);
        await line(writeExact(each[key]));
      }
    if (!kAbout.some(([key]) => has(each, key))) return;
    await go(kMore);
    await keys("Enter");
    for (const [key, name] of kAbout)
      if (has(each, key)) {
        await go(name);
        await line(typeText(each[key] ?? null));
      }
  };
  /** Adds a row to a list, which is behind the focus, or before it once the list has rows; its first field has the focus then. */
  const add = async (one: string, isFirst: boolean, first: string): Promise<void> => {
    await go(`Add ${one}`, isFirst ? "Tab" : "Shift+Tab");
    await keys("Enter");
    await expect.poll(() => heard(page)).toBe(first);
  };
  return {
    keys, go, line, code,
    /** From a form back to the drawing. */
    toDrawing: async (): Promise<void> => {
      await keys("Escape");
      await expect.poll(() => heard(page)).toContain("Drawing of");
    },
    /** Writes the data of a state; the focus is before them. */
    data: async (state: ExactObject): Promise<void> => {
      for (const [key, , one] of kLists)
        for (const [i, each] of objects(state[key]).entries()) {
          await add(one, i === 0, "Name");
          await datum(each);
        }
    },
    /** Writes the functions of a state, then its ports; the focus is before them. */
    rest: async (state: ExactObject): Promise<void> => {
      if (has(state, "entry")) {
        await go("Entry");
        await code(textOf(state["entry"]));
      }
      for (const [i, each] of objects(state["actions"]).entries()) {
        await add("action", i === 0, "Condition");
        await line(textOf(each["when"]));
        await go("Function");
        await code(textOf(each["do"]));
      }
      for (const [i, each] of objects(state["ports"]).entries()) {
        await add("port", i === 0, "Name");
        await line(textOf(each["name"]));
        if (has(each, "after")) {
          await go("Condition: make it a time-out");
          await keys("Enter");
          await go("Time-out in seconds");
          await line(textOf(each["after"]));
        } else {
          await go("Condition");
          await line(textOf(each["when"]));
        }
      }
    },
  };
}

/** As if a person had said that these documents may move something. Requires a page of the server. */
export const letMove = (page: Page, ...documents: readonly string[]): Promise<void> =>
  page.evaluate((names) => names.forEach((name) => sessionStorage.setItem(`race.moves.${name}`, "1")), documents);
