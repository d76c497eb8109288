// Two people change the same thing at once: nothing that either has written is lost, and both are told where it happened. What one page sends can be held
// back (`hold`), so that it comes after what the other does.
import type { Page } from "playwright-core";
import { findings } from "./axe";
import { write } from "./editPage";
import { openFixture, settled, type Fixture } from "./fixture";
import { kPatience } from "./patience";

let fixture: Fixture;
let ada: Page;
let bob: Page;
/** Holds what Ada sends; the result sends it. */
let hold: () => () => void;

const task = {
  rcm: 1,
  root: {
    state: "Root", first: "A",
    children: [
      { state: "A", ports: [{ name: "done", when: "True", to: "B" }] },
      { state: "B", parameters: [{ name: "speed", value: 0.1 }], ports: [{ name: "done", when: "False" }] },
      { state: "C", first: "D", children: [{ state: "D" }] },
    ],
  },
};

async function enter(as: string): Promise<Page> {
  const page = await fixture.openPage({ width: 1366, height: 768 });
  page.setDefaultTimeout(kPatience);
  await page.addInitScript((own) => localStorage.setItem("race.name", own), as);
  return page;
}
async function open(page: Page, name: string): Promise<void> {
  await page.goto(`${fixture.url}/pro/?edit=${name}`);
  await settled(page);
}

const canvasOf = (page: Page) => page.locator("#edit-canvas");
const node = (page: Page, path: string) => canvasOf(page).locator(`[data-path="${path}"]`);
async function select(page: Page, path: string): Promise<void> {
  await settled(page);
  await node(page, path).click({ position: { x: 20, y: 8 } });
}
const told = (page: Page) => page.getByRole("log", { name: "Refused edits" });
const form = (page: Page) => page.getByRole("complementary", { name: "Properties" });
const doc = (page: Page) => form(page).getByRole("textbox", { name: "Description" });
const met = (page: Page) => form(page).getByRole("group", { name: "Set by somebody else, too" });
const storedDoc = async (name: string) => JSON.stringify(((await fixture.send("GET", `/documents/${name}`)) as { readonly document: object }).document);

async function describeState(page: Page, text: string): Promise<void> {
  await doc(page).fill(text);
  await doc(page).press("Control+Enter");
}

beforeAll(async () => {
  fixture = await openFixture();
  [ada, bob] = [await enter("Ada"), await enter("Bob")];
  let held: (() => void)[] | undefined;
  await ada.routeWebSocket(/\/stream/, (socket) => {
    const server = socket.connectToServer();
    socket.onMessage((message) => {
      const send = () => server.send(message);
      if (held === undefined) send();
      else held.push(send);
    });
  });
  hold = () => {
    const mine: (() => void)[] = (held = []);
    return () => {
      held = undefined;
      mine.forEach((send) => send());
    };
  };
  await ada.context().grantPermissions(["clipboard-read", "clipboard-write"], { origin: fixture.url });
});
afterAll(() => fixture.close());

async function both(name: string): Promise<void> {
  await fixture.send("PUT", `/documents/${name}`, task);
  await open(ada, name);
  await open(bob, name);
}

describe("two people change the same thing at once", () => {
  it("a field: who comes last holds, both can choose, and nothing is lost", async () => {
    await both("field");
    for (const page of [ada, bob]) await select(page, "Root/B");
    const release = hold();
    await describeState(ada, "from Ada");
    await describeState(bob, "from Bob");
    await met(ada).getByText("Bob has set doc of state Root/B to “from Bob”. Yours: “from Ada”.").waitFor();
    release();
    await met(bob).getByText("Ada has set doc of state Root/B to “from Ada”. Yours: “from Bob”.").waitFor();
    await expect.poll(() => doc(bob).inputValue()).toBe("from Ada");
    for (const colorScheme of ["light", "dark"] as const) {
      await bob.emulateMedia({ colorScheme, reducedMotion: "reduce" });
      expect(await findings(bob)).toEqual([]);
      await fixture.screenshot(`conflict-${colorScheme}`, bob);
    }
    await met(ada).getByRole("button", { name: "Take theirs" }).click();
    await expect.poll(() => doc(bob).inputValue()).toBe("from Bob");
    await expect.poll(() => met(ada).count(), { message: "she has chosen" }).toBe(0);
    expect(await told(ada).getByRole("listitem").count()).toBe(0);
  });

  it("a text that is being written: it stays, with what the other has made of it", async () => {
    await both("draft");
    for (const page of [ada, bob]) await select(page, "Root/A");
    await write(doc(ada), "half of Ad");
    await describeState(bob, "from Bob");
    await form(ada).getByText("Bob changed this to from Bob").waitFor();
    expect(await doc(ada).inputValue()).toBe("half of Ad");
    await form(ada).getByRole("button", { name: "Keep mine" }).click();
    await expect.poll(() => storedDoc("draft")).toContain("half of Ad");
  });

  it("deleting what the other changes is refused, says who, and can be tried again", async () => {
    await both("deleted");
    await select(ada, "Root/C");
    const release = hold();
    await canvasOf(ada).focus();
    await ada.keyboard.press("Delete");
    await select(bob, "Root/C/D");
    await describeState(bob, "needed");
    release();
    const line = told(ada).getByRole("listitem").filter({ hasText: "Bob" });
    await line.getByText(/state Root\/C, or what is in it, was changed by Bob/).waitFor();
    await line.getByText("delete state Root/C").waitFor();
    await node(ada, "Root/C/D").waitFor();
    await fixture.screenshot("conflict-refused", ada);
    await line.getByRole("button", { name: "Try again" }).click();
    await expect.poll(() => node(bob, "Root/C").count()).toBe(0);
  });

  it("what is written in a state that the other deletes is kept, and is in its field when the state comes back", async () => {
    await both("gone");
    await select(ada, "Root/A");
    await write(doc(ada), "a long text");
    await select(bob, "Root/A");
    await canvasOf(bob).focus();
    await bob.keyboard.press("Delete");
    await told(ada).getByText(/^Bob has deleted state Root\/A, in which you were writing/).waitFor();
    await ada.getByText("1 unsent text").click();
    await ada.getByRole("button", { name: /^Copy an element that is gone/ }).click();
    await expect.poll(() => ada.evaluate(() => navigator.clipboard.readText())).toBe("a long text");
    await fixture.screenshot("conflict-gone", ada);
    await canvasOf(bob).focus();
    await bob.keyboard.press("Control+Z");
    await node(ada, "Root/A").waitFor();
    await settled(ada);
    await select(ada, "Root/A");
    await expect.poll(() => doc(ada).inputValue()).toBe("a long text");
  });

  it("an edit of what is gone is refused with what it would have written", async () => {
    await both("late");
    await select(ada, "Root/A");
    const release = hold();
    await describeState(ada, "too late");
    await select(bob, "Root/A");
    await canvasOf(bob).focus();
    await bob.keyboard.press("Delete");
    await expect.poll(() => node(ada, "Root/A").count()).toBe(0);
    release();
    const line = told(ada).getByRole("listitem").filter({ hasText: "doc of what is gone: “too late”" });
    await line.getByRole("button", { name: "Copy" }).click();
    await expect.poll(() => ada.evaluate(() => navigator.clipboard.readText())).toBe("too late");
  });

  it("an undo that the other has overtaken is refused, and says by whom", async () => {
    await both("undo");
    for (const page of [ada, bob]) await select(page, "Root/B");
    await describeState(ada, "from Ada");
    await expect.poll(() => doc(bob).inputValue()).toBe("from Ada");
    await describeState(bob, "from Bob");
    await expect.poll(() => doc(ada).inputValue()).toBe("from Bob");
    await canvasOf(ada).focus();
    await ada.keyboard.press("Control+Z");
    await told(ada).getByText(/^Undo was refused: .* by Bob \(revision \d+\)\.$/).waitFor();
    await expect.poll(() => doc(bob).inputValue()).toBe("from Bob");
  });
});
