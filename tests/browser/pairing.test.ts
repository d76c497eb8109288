// A phone is paired: a person who is logged in shows it a code, it scans the code, and may from then on what they have said.
import { execFileSync } from "node:child_process";
import { devices, type Page } from "playwright-core";
import { findings } from "./axe";
import { tap } from "./fingers";
import { binary, openPrepared, type Fixture } from "./fixture";
import { readCode } from "./qrCode";
import { kPatience } from "./patience";

const kPassword = "correct horse battery";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openPrepared((data) => {
    for (const [name, role] of [["ada", "admin"], ["otto", "operator"]] as const) execFileSync(binary, ["account", "add", name, "--role", role, "--data", data], { input: `${kPassword}\n` });
  });
});
afterAll(() => fixture.close());

const dialog = (page: Page) => page.getByRole("dialog", { name: "Pair a phone" });

/** The expert page of an account, with the dialog by which it pairs a phone. */
async function openDialog(name: string): Promise<Page> {
  const page = await (await fixture.openContext({ viewport: { width: 1366, height: 768 } })).newPage();
  page.setDefaultTimeout(kPatience);
  await page.goto(`${fixture.url}/pro/`);
  await page.getByLabel("Name", { exact: true }).fill(name);
  await page.getByLabel("Password", { exact: true }).fill(kPassword);
  await page.keyboard.press("Enter");
  await page.getByRole("tab", { name: "Services" }).click();
  await page.getByRole("button", { name: "Pair a phone" }).click();
  await dialog(page).waitFor();
  return page;
}

/** What the code on the page says. */
async function scan(page: Page): Promise<string> {
  const address = await readCode(page, await dialog(page).getByRole("img", { name: /^QR code of .*#code=/ }).screenshot());
  if (address === undefined) throw new Error("no reader reads the code");
  return address;
}

async function phone(address: string): Promise<Page> {
  const page = await (await fixture.openContext({ ...devices["Pixel 7"] })).newPage();
  page.setDefaultTimeout(kPatience);
  await page.goto(address.replace("localhost", "127.0.0.1"));
  return page;
}

const paired = (page: Page) => page.getByRole("region", { name: "Pairing" });

describe("a phone that scans a code", () => {
  it("is the display that was said, may what was said, and keeps no secret in its address", async () => {
    const page = await openDialog("ada");
    await dialog(page).getByLabel("Name of the display").fill("left");
    await dialog(page).getByLabel("Its place").fill("gripper");
    const address = await scan(page);
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("pairing-code", page);
    const device = await phone(address);
    await paired(device).getByText("Paired by ada until").waitFor();
    await device.getByRole("status", { name: "Connection" }).filter({ hasText: "Connected" }).waitFor();
    await expect.poll(() => new URL(device.url()).hash).toBe("");
    await expect.poll(() => new URL(device.url()).search).toBe("?name=left&place=gripper");
    await fixture.screenshot("paired-phone", device);
    await tap(paired(device).getByRole("button", { name: "OK" }));
    await tap(device.getByRole("link", { name: "Move" }));
    await tap(device.getByRole("button", { name: "Take the controls" }).first());
    await device.getByText("You have the controls").waitFor();
    // It is paired as long as was said, not as long as the page is open.
    await device.reload();
    await device.getByRole("status", { name: "Connection" }).filter({ hasText: "Connected" }).waitFor();
    await device.context().close();
    await page.context().close();
  });

  it("is led to the network that the person chooses, with the same code", async () => {
    const page = await openDialog("ada");
    // As of a machine in two networks: what the server says of itself, and one more.
    await page.route("**/api/v1/pairings", async (route) => {
      const answer = await route.fetch();
      const made = (await answer.json()) as { readonly code: string };
      await route.fulfill({ response: answer, json: { ...made, addresses: [{ url: "https://192.168.1.5:8443" }, { url: "https://10.0.0.7:8443" }] } });
    });
    await dialog(page).getByLabel("Name of the display").fill("right");
    const network = dialog(page).getByLabel("Network of the phone");
    await network.waitFor();
    const first = new URL(await scan(page));
    expect(first.origin).toBe("https://192.168.1.5:8443");
    await network.selectOption("10.0.0.7");
    await dialog(page).getByRole("img", { name: /^QR code of https:\/\/10\.0\.0\.7/ }).waitFor();
    const second = new URL(await scan(page));
    expect(second.origin).toBe("https://10.0.0.7:8443");
    expect([second.search, second.hash]).toEqual([first.search, first.hash]);
    await dialog(page).getByText("Details", { exact: true }).click();
    await dialog(page).getByRole("link", { name: "https://10.0.0.7:8443/trust/" }).waitFor();
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("pairing-networks", page);
    await dialog(page).getByRole("button", { name: "Close" }).click();
    await page.context().close();
  });

  it("is let in by a code once, and says what to do then", async () => {
    fixture.allowError(/status of 401/);
    const page = await openDialog("otto");
    const address = await scan(page);
    const first = await phone(address);
    await paired(first).getByText("Paired by otto until").waitFor();
    const second = await phone(address);
    await paired(second).getByText("Press “New code” on the page that shows it").waitFor();
    await dialog(page).getByRole("button", { name: "New code" }).click();
    await expect.poll(() => scan(page).catch(() => address)).not.toBe(address);
    await second.getByRole("form", { name: "Log in" }).waitFor();
    for (const each of [page, first, second]) await each.context().close();
  });

  it("changes nothing as an observer", async () => {
    const page = await openDialog("ada");
    await dialog(page).getByLabel("What it may").selectOption("observer");
    await page.waitForTimeout(300);
    const device = await phone(await scan(page));
    await paired(device).getByText("sees everything, changes nothing").waitFor();
    await tap(paired(device).getByRole("button", { name: "OK" }));
    await tap(device.getByRole("link", { name: "Move" }));
    await expect.poll(() => device.getByRole("button", { name: "Take the controls" }).first().isDisabled()).toBe(true);
    for (const each of [page, device]) await each.context().close();
  });
});
