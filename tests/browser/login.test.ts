// A server with accounts: the login, what a role may do, the accounts that an admin manages, and a display that logs in.
import { execFileSync } from "node:child_process";
import type { Page } from "playwright-core";
import { findings } from "./axe";
import { binary, openPrepared, settled, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

const kPassword = "correct horse battery";

const account = (data: string, name: string, role: string) => execFileSync(binary, ["account", "add", name, "--role", role, "--data", data], { input: `${kPassword}\n` });

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openPrepared((data) => {
    account(data, "ada", "admin");
    account(data, "dev", "developer");
    account(data, "olga", "observer");
    account(data, "otto", "operator");
  });
  fixture.page.setDefaultTimeout(kPatience);
});
afterAll(() => fixture.close());

async function logIn(page: Page, name: string, password = kPassword): Promise<void> {
  await page.getByLabel("Name", { exact: true }).fill(name);
  await page.getByLabel("Password", { exact: true }).fill(password);
  await page.keyboard.press("Enter");
}
/** A request of an account. */
async function sendAs(name: string, path: string, body?: unknown): Promise<unknown> {
  const post = async (to: string, content: unknown, headers: Record<string, string>) => {
    const answer = await fetch(`${fixture.url}/api/v1${to}`, { method: "POST", body: content === undefined ? null : JSON.stringify(content), headers: { "content-type": "application/json", ...headers } });
    if (!answer.ok) throw new Error(`${to}: ${answer.status} ${await answer.text()}`);
    return answer.json() as Promise<unknown>;
  };
  const { token } = (await post("/login", { name, password: kPassword }, {})) as { readonly token: string };
  return post(path, body, { authorization: `Bearer ${token}` });
}

/** A browser of its own, logged in on this page. */
async function openAs(name: string, path: string): Promise<Page> {
  const page = await (await fixture.openContext({ viewport: { width: 1366, height: 768 } })).newPage();
  page.setDefaultTimeout(kPatience);
  await page.goto(`${fixture.url}${path}`);
  await logIn(page, name);
  await cover(page).waitFor({ state: "detached" });
  return page;
}

const cover = (page: Page) => page.getByRole("dialog", { name: "Log in to RACE" });

describe("the page of a server with accounts", () => {
  it("shows nothing before a login", async () => {
    const { page } = fixture;
    await page.goto(`${fixture.url}/pro/`);
    await cover(page).waitFor();
    await expect.poll(() => page.evaluate(() => document.activeElement?.getAttribute("autocomplete")), kSoon).toBe("username");
    expect(await page.getByRole("banner").count()).toBe(0);
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("login");
    await page.keyboard.press("Escape");
    expect(await cover(page).isVisible()).toBe(true);
  });

  it("says that a password is wrong, without saying which names there are", async () => {
    const { page } = fixture;
    fixture.allowError(/status of 401/);
    await logIn(page, "ada", "a wrong password");
    const alert = cover(page).getByRole("alert");
    await expect.poll(() => alert.innerText(), kSoon).toContain("no account of this name with this password");
    await logIn(page, "nobody");
    await expect.poll(() => alert.innerText(), kSoon).toContain("no account of this name with this password");
  });

  it("goes on where it was once somebody has logged in, and after a reload", async () => {
    const { page } = fixture;
    await logIn(page, "ada");
    await cover(page).waitFor({ state: "detached" });
    await page.getByText("Connected", { exact: true }).waitFor();
    await page.getByRole("button", { name: "ada admin" }).waitFor();
    await page.reload();
    await page.getByRole("button", { name: "ada admin" }).waitFor();
    expect(await cover(page).count()).toBe(0);
    await fixture.screenshot("logged-in");
  });

  it("lets an admin make, change and remove accounts", async () => {
    const { page } = fixture;
    await page.getByRole("button", { name: "ada admin" }).click();
    await page.getByRole("menuitem", { name: "Accounts…" }).click();
    const panel = page.getByRole("dialog", { name: "Accounts" });
    await panel.getByLabel("Name of the account").fill("eve");
    await panel.getByLabel("Password of the account").fill(kPassword);
    await panel.getByLabel("Role of the account").selectOption("observer");
    await panel.getByRole("button", { name: "Add" }).click();
    const row = panel.getByRole("listitem", { name: "eve" });
    await expect.poll(() => row.getByLabel("Role of eve").inputValue(), kSoon).toBe("observer");
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("accounts");
    await row.getByLabel("Role of eve").selectOption("operator");
    await expect.poll(() => row.getByLabel("Role of eve").inputValue(), kSoon).toBe("operator");
    expect(await panel.getByRole("listitem", { name: "ada" }).getByRole("button", { name: "Remove" }).isDisabled()).toBe(true);
    await row.getByRole("button", { name: "Remove" }).click();
    await row.getByRole("button", { name: "Remove eve and all its tokens" }).click();
    await row.waitFor({ state: "detached" });
    await page.keyboard.press("Escape");
  });

  it("covers itself when its account logs out, on every page of the browser", async () => {
    const { page } = fixture;
    const second = await page.context().newPage();
    await second.goto(`${fixture.url}/pro/`);
    await second.getByText("Connected", { exact: true }).waitFor();
    await page.getByRole("button", { name: "ada admin" }).click();
    await page.getByRole("menuitem", { name: "Log out" }).click();
    await cover(page).waitFor();
    await cover(second).waitFor();
    await second.close();
    await logIn(page, "dev");
    await page.getByRole("button", { name: "dev developer" }).waitFor();
    await page.getByRole("button", { name: "dev developer" }).click();
    await expect.poll(() => page.getByRole("menuitem").allInnerTexts(), kSoon).toEqual(["Log out"]);
    await page.keyboard.press("Escape");
  });

  it("signs edits with the account", async () => {
    const { page } = fixture;
    await page.goto(`${fixture.url}/pro/?edit=pick`);
    await settled(page);
    await page.getByRole("img", { name: "You are dev" }).waitFor();
  });
});

describe("several pages of one browser", () => {
  it("take over the login of one of them, and a change of the account", async () => {
    const first = await openAs("dev", "/pro/");
    const second = await first.context().newPage();
    second.setDefaultTimeout(kPatience);
    await second.goto(`${fixture.url}/pro/`);
    await second.getByRole("button", { name: "dev developer" }).waitFor();
    await second.getByText("Connected", { exact: true }).waitFor();
    await first.getByRole("button", { name: "dev developer" }).click();
    await first.getByRole("menuitem", { name: "Log out" }).click();
    await cover(second).waitFor();
    await logIn(first, "olga");
    await cover(second).waitFor({ state: "detached" });
    await second.getByRole("button", { name: "olga observer" }).waitFor();
    await second.getByText("Connected", { exact: true }).waitFor();
    await expect.poll(() => second.getByRole("banner").getByText("Read only").isVisible(), kSoon).toBe(true);
    await first.context().close();
  });
});

describe("an observer", () => {
  const why = (role: string) => `this needs the role ${role}, and your account has the role observer`;
  let page: Page;
  beforeAll(async () => {
    const { id } = (await sendAs("otto", "/cores", { document: "pick", arguments: {} })) as { readonly id: string };
    page = await openAs("olga", `/pro/?run=${id}`);
    await settled(page);
  });
  afterAll(() => page.context().close());
  const needs = async (name: string, role: string, within = page.getByRole("toolbar", { name: "Run" })) => {
    const button = within.getByRole("button", { name, exact: true });
    await expect.poll(async () => [await button.isDisabled(), await button.getAttribute("title")], { ...kSoon, message: name }).toEqual([true, expect.stringContaining(why(role))]);
  };

  it("is told that the page is read only, and why", async () => {
    const badge = page.getByRole("banner").getByText("Read only");
    expect(await badge.getAttribute("title")).toBe("Your account is an observer: sees everything, changes nothing. An admin can give it another role.");
    await page.getByRole("button", { name: "olga observer" }).click();
    expect(await page.getByRole("menu", { name: "Account" }).innerText()).toContain("sees everything, changes nothing");
    await fixture.screenshot("observer-run", page);
    await page.keyboard.press("Escape");
  });

  it("neither makes, starts nor steps a run, also not by key", async () => {
    await needs("Start", "operator");
    await needs("Micro step", "developer");
    await needs("Step over", "developer");
    await needs("Load", "operator", page.getByRole("banner"));
    await page.keyboard.press("F5");
    await page.getByText(`Not done: ${why("operator")}.`).waitFor();
    expect(await findings(page)).toEqual([]);
  });

  it("stores and deletes nothing", async () => {
    await page.keyboard.press("Control+o");
    const documents = page.getByRole("dialog", { name: "Documents" });
    await needs("New", "developer", documents);
    await needs("Upload", "developer", documents);
    const pick = documents.getByRole("listitem", { name: "pick" });
    for (const name of ["Duplicate", "Delete"]) await needs(name, "developer", pick);
    await needs("New run", "operator", pick);
    await expect.poll(() => pick.getByRole("button", { name: "Download" }).isDisabled(), kSoon).toBe(false);
    await fixture.screenshot("observer-documents", page);
    await page.keyboard.press("Escape");
  });

  it("looks at a document, and changes nothing in it", async () => {
    await page.goto(`${fixture.url}/pro/?edit=pick`);
    await settled(page);
    const head = page.locator(".edit-head");
    expect(await head.getByText("Read only").getAttribute("title")).toBe(why("developer"));
    for (const name of ["Undo", "Redo"]) await needs(name, "developer", head);
    await needs("State", "developer", page.getByRole("region", { name: "Add" }));
    await page.getByRole("treeitem").first().click();
    const properties = page.getByRole("complementary", { name: "Properties" });
    await properties.getByRole("textbox", { name: "Name", exact: true }).first().waitFor();
    await expect.poll(() => properties.locator("input:not([readonly]):not(:disabled), textarea:not([readonly]), select:not(:disabled), [contenteditable=true]:not([aria-readonly=true])").count(), kSoon).toBe(0);
    await fixture.screenshot("observer-edit", page);
    await page.locator("#edit-canvas").focus();
    await page.keyboard.press("Delete");
    await page.getByText(`Not done: ${why("developer")}.`).waitFor();
    expect(await findings(page)).toEqual([]);
  });

  it("can choose the commands that only look", async () => {
    await page.keyboard.press("Control+Shift+p");
    const palette = page.getByRole("dialog", { name: "Commands" });
    await palette.getByRole("combobox").waitFor();
    const free = await palette.locator('[role=option]:not([aria-disabled=true])').evaluateAll((options) => options.map((option) => option.firstElementChild?.textContent ?? ""));
    const changing = /^(?:Add|Delete|Cut|Paste|Duplicate|Group|Rename|Undo|Redo|Make a run|Pause|Stop|Toggle breakpoint|Step|Reset|Comment$|Lay out|Keep layout|Write a note|Connect|Disconnect|Leave through|Move)/;
    expect(free.filter((name) => changing.test(name))).toEqual([]);
    expect(free).toEqual(expect.arrayContaining(["Copy", "Properties", "Find usages", "Search states, ports and code"]));
    await fixture.screenshot("observer-palette", page);
    await page.keyboard.press("Escape");
  });

  it("is no display", async () => {
    await page.goto(`${fixture.url}/display/?name=phone2`);
    await page.getByText(why("operator")).first().waitFor();
    await fixture.screenshot("observer-display", page);
  });
});

describe("an operator", () => {
  it("starts a run, and neither steps nor edits", async () => {
    const { id } = (await sendAs("otto", "/cores", { document: "pick", arguments: {} })) as { readonly id: string };
    const page = await openAs("otto", `/pro/?run=${id}`);
    await settled(page);
    const bar = page.getByRole("toolbar", { name: "Run" });
    expect(await page.getByText("Read only").count()).toBe(0);
    await expect.poll(() => bar.getByRole("button", { name: "Macro step" }).isDisabled(), kSoon).toBe(true);
    await bar.getByRole("button", { name: "Start" }).click();
    await page.getByRole("alertdialog", { name: "Before it moves" }).getByRole("button", { name: "Start" }).click();
    await bar.getByRole("status", { name: "Run status" }).filter({ hasNotText: "Ready" }).waitFor();
    await fixture.screenshot("operator-run", page);
    await page.context().close();
  });
});

describe("a display of a server with accounts", () => {
  it("logs in", async () => {
    const phone = await (await fixture.openContext({ viewport: { width: 390, height: 844 } })).newPage();
    await phone.goto(`${fixture.url}/display/?name=phone1`);
    await logIn(phone, "dev");
    await phone.getByText("Connected", { exact: true }).waitFor();
    await fixture.screenshot("login-display", phone);
    await phone.close();
  });
});
