// A server with accounts: the login, what a role may do, the accounts that an admin manages, and a display that logs in.
import { execFileSync } from "node:child_process";
import type { Page } from "playwright-core";
import { findings } from "./axe";
import { binary, openPrepared, settled, type Fixture } from "./fixture";

const kPassword = "correct horse battery";
const kSoon = { timeout: 20_000 };

const account = (data: string, name: string, role: string) => execFileSync(binary, ["account", "add", name, "--role", role, "--data", data], { input: `${kPassword}\n` });

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openPrepared((data) => {
    account(data, "ada", "admin");
    account(data, "dev", "developer");
  });
  fixture.page.setDefaultTimeout(20_000);
});
afterAll(() => fixture.close());

async function logIn(page: Page, name: string, password = kPassword): Promise<void> {
  await page.getByLabel("Name", { exact: true }).fill(name);
  await page.getByLabel("Password", { exact: true }).fill(password);
  await page.keyboard.press("Enter");
}
const cover = (page: Page) => page.getByRole("dialog", { name: "Log in to RACE" });

describe("the page of a server with accounts", () => {
  it("shows nothing before a login", async () => {
    const { page } = fixture;
    await page.goto(`${fixture.url}/pro/`);
    await cover(page).waitFor();
    expect(await page.evaluate(() => document.activeElement?.getAttribute("autocomplete"))).toBe("username");
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
    expect(await page.getByRole("menuitem").allInnerTexts()).toEqual(["Log out"]);
    await page.keyboard.press("Escape");
  });

  it("signs edits with the account", async () => {
    const { page } = fixture;
    await page.goto(`${fixture.url}/pro/?edit=pick`);
    await settled(page);
    await page.getByRole("img", { name: "You are dev" }).waitFor();
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
