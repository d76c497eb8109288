// Comments on states: two people, each in a browser of their own, talk beside a state; a run shows what was said, and has no part of it.
import type { Page } from "playwright-core";
import { largeDocument } from "../bench/pages/large_document.mjs";
import { findings } from "./axe";
import { kTask } from "./editPage";
import { openFixture, settled, type Fixture } from "./fixture";
import { kPatience } from "./patience";

let fixture: Fixture;
let ada: Page;
let bob: Page;

async function enter(name: string, as: string): Promise<Page> {
  const page = await fixture.openPage({ width: 1366, height: 768 });
  page.setDefaultTimeout(kPatience);
  await page.addInitScript((own) => localStorage.setItem("race.name", own), as);
  await page.goto(`${fixture.url}/pro/?edit=${name}`);
  await settled(page);
  return page;
}

const canvasOf = (page: Page) => page.locator("#edit-canvas");
const node = (page: Page, path: string) => canvasOf(page).locator(`[data-path="${path}"]`);
async function select(page: Page, path: string): Promise<void> {
  await settled(page);
  await node(page, path).click({ position: { x: 20, y: 8 } });
}
const comments = (page: Page) => page.getByRole("region", { name: "Comments", exact: true });
const thread = (page: Page, of: string) => comments(page).getByRole("article", { name: `Comment of ${of}` });
const field = (page: Page) => comments(page).getByRole("textbox", { name: "New comment" });
const mark = (page: Page, path: string) => canvasOf(page).locator(".comment-marks").getByRole("button", { name: new RegExp(`on ${path}$`) });
const row = (page: Page, path: string) => page.getByRole("treeitem", { name: path, exact: true });
const said = (page: Page, of: string) => thread(page, of).locator(".said-text").allInnerTexts();

beforeAll(async () => {
  fixture = await openFixture();
  await fixture.send("PUT", "/documents/commented", kTask);
  [ada, bob] = [await enter("commented", "Ada"), await enter("commented", "Bob")];
});
afterAll(() => fixture.close());

describe("comments on states", () => {
  it("are written by keyboard, and are seen by the other at once, as text", async () => {
    await select(ada, "Root/A");
    await ada.keyboard.press("Control+Alt+m");
    await expect.poll(() => field(ada).evaluate((element) => element === document.activeElement)).toBe(true);
    await ada.keyboard.insertText("Is <b>this</b> right?\nIt <img src=x onerror=alert(1)> fires at once.");
    await ada.keyboard.press("Control+Enter");
    await mark(bob, "Root/A").waitFor();
    await row(bob, "Root/A").getByRole("img", { name: "1 open comment" }).waitFor();
    await mark(bob, "Root/A").click();
    await thread(bob, "Ada").waitFor();
    await expect.poll(() => said(bob, "Ada")).toEqual(["Is <b>this</b> right?\nIt <img src=x onerror=alert(1)> fires at once."]);
    expect(await thread(bob, "Ada").locator("img, p b").count()).toBe(0);
    await expect.poll(() => field(ada).inputValue(), { message: "the next comment begins" }).toBe("");
    await expect.poll(() => field(ada).evaluate((element) => element === document.activeElement)).toBe(true);
  });

  it("are answered, changed by their author alone, and taken back by who did it", async () => {
    const answer = thread(bob, "Ada").getByRole("textbox", { name: "Answer to Ada" });
    await answer.fill("It waits for nothing.");
    await answer.press("Control+Enter");
    await expect.poll(() => said(ada, "Ada")).toHaveLength(2);
    const first = (page: Page) => thread(page, "Ada").locator(".said").first();
    expect(await first(bob).getByRole("button", { name: "Edit" }).count()).toBe(0);
    await first(ada).getByRole("button", { name: "Edit" }).click();
    await first(ada).getByRole("textbox", { name: "Your comment" }).fill("Is this right?");
    await first(ada).getByRole("button", { name: "Save" }).click();
    await expect.poll(async () => (await said(bob, "Ada"))[0]).toBe("Is this right?");
    await canvasOf(bob).focus();
    await bob.keyboard.press("Control+Z");
    await expect.poll(() => said(ada, "Ada"), { message: "Bob takes back his answer, not what Ada did after it" }).toEqual(["Is this right?"]);
    await bob.keyboard.press("Control+Y");
    await expect.poll(() => said(ada, "Ada")).toHaveLength(2);
  });

  it("are listed, each a link to its thread", async () => {
    await row(bob, "Root/Both").locator(".tree-name").click();
    await field(bob).fill("Which of them first?");
    await comments(bob).getByRole("button", { name: "Comment", exact: true }).click();
    await select(ada, "Root/B");
    await ada.getByRole("button", { name: "2 open comments" }).first().click();
    const list = ada.getByRole("region", { name: "Open comments" });
    await list.getByRole("button", { name: /barrier Root\/Both/ }).click();
    await thread(ada, "Bob").waitFor();
    await expect.poll(() => thread(ada, "Bob").evaluate((element) => element === document.activeElement)).toBe(true);
    for (const colorScheme of ["light", "dark"] as const) {
      await ada.emulateMedia({ colorScheme, reducedMotion: "reduce" });
      await select(ada, "Root/A");
      await thread(ada, "Ada").waitFor();
      expect(await findings(ada)).toEqual([]);
      await fixture.screenshot(`comments-${colorScheme}`, ada);
    }
    await list.getByRole("button", { name: "Close the comments" }).click();
  });

  it("are resolved and opened again", async () => {
    await row(ada, "Root/Both").locator(".tree-name").click();
    await thread(ada, "Bob").getByRole("button", { name: "Resolve" }).click();
    await expect.poll(() => mark(bob, "Root/Both").count()).toBe(0);
    await row(bob, "Root/Both").locator(".tree-name").click();
    await comments(bob).getByText("1 resolved").click();
    await thread(bob, "Bob").getByText("Resolved by Ada").waitFor();
    await thread(bob, "Bob").getByRole("button", { name: "Reopen" }).click();
    await mark(ada, "Root/Both").waitFor();
  });

  it("go with their state and come back with it; a copy has none", async () => {
    await select(ada, "Root/A");
    await ada.keyboard.press("Control+d");
    await node(bob, "Root/A2").waitFor();
    await settled(bob);
    expect(await mark(bob, "Root/A2").count()).toBe(0);
    await select(ada, "Root/A");
    await ada.keyboard.press("Delete");
    await expect.poll(() => node(bob, "Root/A").count()).toBe(0);
    await bob.getByRole("button", { name: "1 open comment", exact: true }).waitFor();
    await canvasOf(ada).focus();
    await ada.keyboard.press("Control+Z");
    await mark(bob, "Root/A").waitFor();
    await select(bob, "Root/A");
    await expect.poll(() => said(bob, "Ada")).toHaveLength(2);
  });

  it("that are not sent stay drafts, also over a reload", async () => {
    await select(bob, "Root/B");
    await field(bob).fill("Half a thou");
    await select(bob, "Root/A");
    await bob.reload();
    await settled(bob);
    await bob.getByText("1 unsent text").click();
    await bob.getByRole("button", { name: /Root › B › comment/ }).first().click();
    await expect.poll(() => field(bob).first().inputValue()).toBe("Half a thou");
    await comments(bob).getByRole("button", { name: "Discard" }).click();
    await expect.poll(() => bob.getByText("1 unsent text").count()).toBe(0);
  });

  it("are read beside a run, which has no part of them", async () => {
    const { id } = (await fixture.send("POST", "/cores", { document: "commented", arguments: {} })) as { readonly id: string };
    await fixture.send("PUT", `/cores/${id}/live`, { live: true });
    await fixture.send("POST", `/cores/${id}/start`);
    await bob.goto(`${fixture.url}/pro/?run=${id}`);
    await settled(bob);
    await row(bob, "Root/A").locator(".tree-name").click();
    await thread(bob, "Ada").waitFor();
    expect(await comments(bob).getByRole("textbox").count()).toBe(0);
    const stepOf = async () => ((await fixture.send("GET", `/cores/${id}`)) as { readonly step: number }).step;
    const before = await stepOf();
    await select(ada, "Root/A");
    const answer = thread(ada, "Ada").getByRole("textbox", { name: "Answer to Ada" });
    await answer.fill("So it is.");
    await answer.press("Control+Enter");
    await expect.poll(() => said(bob, "Ada")).toHaveLength(3);
    expect(await stepOf()).toBe(before);
    await fixture.screenshot("comments-run", bob);
    await comments(bob).getByRole("button", { name: "Answer in the editor" }).click();
    await settled(bob);
    await thread(bob, "Ada").waitFor();
    await expect.poll(() => field(bob).evaluate((element) => element === document.activeElement)).toBe(true);
  });
});

it("a painted drawing shows them, too", async () => {
  await fixture.send("PUT", "/documents/large", largeDocument(20));
  const page = await enter("large", "Ada");
  await page.locator(".painted").waitFor();
  await page.getByRole("tree", { name: "State tree" }).getByRole("treeitem").nth(3).locator(".tree-name").click();
  await settled(page);
  await field(page).fill("Too many of these");
  await field(page).press("Control+Enter");
  await canvasOf(page).locator(".comment-marks .comment-mark").first().waitFor();
  await fixture.screenshot("comments-painted", page);
});
