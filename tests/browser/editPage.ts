// A page that edits a document: what tests of its commands and gestures do with it.
import type { Locator, Page } from "playwright-core";
import { settled, type Fixture } from "./fixture";

interface NodeJson {
  readonly state?: string;
  readonly barrier?: string;
  readonly to?: readonly string[];
  readonly first?: string;
  readonly link?: string;
  readonly children?: readonly NodeJson[];
  readonly ports?: readonly { readonly name: string; readonly to?: string; readonly when?: string }[];
}
export interface DocumentJson {
  readonly root: NodeJson;
  readonly library?: readonly NodeJson[];
}

/** Root: A (done -> B), B (done), C with D inside, the barrier Both. */
export const kTask = {
  rcm: 1,
  root: {
    state: "Root", first: "A",
    children: [
      { state: "A", ports: [{ name: "done", when: "True", to: "B" }] },
      { state: "B", ports: [{ name: "done", when: "False" }] },
      { state: "C", first: "D", children: [{ state: "D" }] },
      { barrier: "Both", to: ["C"] },
    ],
  },
};

export function editPage({ page, url, send }: Fixture) {
  const canvas = page.locator("#edit-canvas");
  const node = (path: string) => canvas.locator(`[data-path="${path}"]`);
  const port = (address: string) => canvas.locator(`[data-address="${address}"]`);
  const stored = async (name: string) => ((await send("GET", `/documents/${name}`)) as { readonly document: DocumentJson }).document;
  return {
    canvas, node, port, stored,
    /** Stores a document and opens it. */
    open: async (name: string, document: unknown = kTask) => {
      await send("PUT", `/documents/${name}`, document);
      await page.goto(`${url}/pro/?edit=${name}`);
      await settled(page);
    },
    /** Names of the children of the root, as the server has them. */
    children: async (name: string) => (await stored(name)).root.children?.map((child) => child.state ?? child.barrier),
    /** The state of this name, as the server has it. */
    state: async (name: string, state: string) => {
      const all = (at: NodeJson): readonly NodeJson[] => [at, ...(at.children ?? []).flatMap(all)];
      const document = await stored(name);
      return [document.root, ...(document.library ?? [])].flatMap(all).find((each) => (each.state ?? each.barrier) === state);
    },
    select: async (path: string) => {
      await settled(page);
      await node(path).click({ position: { x: 20, y: 8 } });
    },
    told: page.getByRole("log", { name: "Refused edits" }),
  };
}

/** Until a completion that begins so is offered, and counts: keys do when it has been there for a moment (75 ms, by CodeMirror), and is not computed anew. */
export async function offered(page: Page, begin: string): Promise<void> {
  await page.locator(".cm-tooltip-autocomplete:not(.cm-tooltip-autocomplete-disabled) li").filter({ hasText: new RegExp(`^${begin}`) }).first().waitFor();
  await page.waitForTimeout(150);
}

/** The middle of an element on the screen. */
export async function middle(page: Page, selector: string): Promise<{ readonly x: number; readonly y: number }> {
  const box = await page.locator(selector).boundingBox();
  if (box === null) throw new Error(`${selector} is not on the screen`);
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Types over what is written in a field, of code too, which is no input. */
export async function write(field: Locator, text: string): Promise<void> {
  await field.click();
  await field.press("Control+A");
  if (text === "") await field.press("Delete");
  else await field.page().keyboard.insertText(text);
}
