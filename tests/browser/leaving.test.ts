// RACE-One: an application is left while the server is not there, with edits that it has not taken. On the real server.
import type { Page } from "playwright-core";
import { findings } from "./axe";
import { openFixture, type Fixture } from "./fixture";
import { kPatience } from "./patience";

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  ({ page } = fixture);
  page.setDefaultTimeout(kPatience);
  await page.emulateMedia({ reducedMotion: "reduce" });
});
afterAll(() => fixture.close());

const question = () => page.getByRole("alertdialog", { name: /not saved yet|All is saved now/ });
const press = (name: string) => question().getByRole("button", { name }).click();
const tasks = (of = page) => of.getByRole("region", { name: /^Task / }).evaluateAll((each) => each.map((one) => one.getAttribute("aria-label")));
const open = () => new URL(page.url()).searchParams.get("edit");
const connection = (text: string) => page.getByRole("status", { name: "Connection" }).filter({ hasText: text }).waitFor();
const leave = () => page.getByRole("link", { name: "RACE One" }).click();
const stored = async (): Promise<readonly string[]> => {
  const { document } = (await fixture.send("GET", "/documents/left")) as { readonly document: { readonly root: { readonly children?: readonly { readonly state: string }[] } } };
  return (document.root.children ?? []).map(({ state }) => state);
};

async function addTask(name: string): Promise<void> {
  const more = page.getByRole("button", { name: "+ Add a task" });
  if ((await more.count()) > 0) await more.click();
  await page.getByLabel("Name of the task").fill(name);
  await page.getByRole("button", { name: "Add the task" }).click();
  await page.getByRole("region", { name: `Task ${name}` }).waitFor();
}

async function lose(): Promise<void> {
  await fixture.kill();
  await connection("Connection lost");
}

describe("an application with edits that the server has not taken", () => {
  it("is left at once while the server is there", async () => {
    await page.goto(`${fixture.url}/one/`);
    await page.getByLabel("A new application").fill("left");
    await page.getByRole("button", { name: "Begin" }).click();
    await addTask("First");
    await leave();
    await page.getByRole("heading", { name: "What shall the robot do?" }).waitFor();
    expect(await question().count()).toBe(0);
    await expect.poll(stored).toEqual(["First"]);
    await page.getByRole("link", { name: /^left/ }).click();
    await page.getByRole("region", { name: "Task First" }).waitFor();
  });

  it("asks before it is left for the list, and stays as it is", async () => {
    await lose();
    await addTask("Second");
    await leave();
    await question().getByRole("heading", { name: "1 change is not saved yet" }).waitFor();
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("one-leaving");
    await press("Stay here");
    await question().waitFor({ state: "detached" });
    expect([open(), await tasks()]).toEqual(["left", ["Task First", "Task Second"]]);
    await leave();
    await page.keyboard.press("Escape");
    await question().waitFor({ state: "detached" });
    expect([open(), await tasks()]).toEqual(["left", ["Task First", "Task Second"]]);
  });

  it("asks when the browser goes back, and the address stays as it is", async () => {
    await page.evaluate(() => history.back());
    await question().waitFor();
    await expect.poll(open).toBe("left");
    await press("Stay here");
    expect([open(), await tasks()]).toEqual(["left", ["Task First", "Task Second"]]);
  });

  it("asks when the page is closed", async () => {
    const asked = page.waitForEvent("dialog");
    await page.close({ runBeforeUnload: true });
    const dialog = await asked;
    expect(dialog.type()).toBe("beforeunload");
    await dialog.dismiss();
    expect(await tasks()).toEqual(["Task First", "Task Second"]);
  });

  it("says when all is saved after all, and is left then", async () => {
    await page.evaluate(() => history.back());
    await question().waitFor();
    await fixture.restart();
    await question().getByRole("heading", { name: "All is saved now" }).waitFor();
    await fixture.screenshot("one-leaving-saved");
    await press("Leave");
    await page.getByRole("heading", { name: "What shall the robot do?" }).waitFor();
    await expect.poll(() => open()).toBeNull();
    expect(await stored()).toEqual(["First", "Second"]);
    await page.evaluate(() => history.forward());
    await page.getByRole("region", { name: "Task Second" }).waitFor();
  });

  it("is left without them if a person says so, by the browser's Back, too", async () => {
    await lose();
    await addTask("Third");
    await page.evaluate(() => history.back());
    await question().waitFor();
    await press("Leave, and lose it");
    await page.getByRole("heading", { name: "What shall the robot do?" }).waitFor();
    await expect.poll(() => open()).toBeNull();
    await fixture.restart();
    await page.getByText("Connected", { exact: true }).waitFor();
    expect(await stored()).toEqual(["First", "Second"]);
    await page.getByRole("link", { name: /^left/ }).click();
    await page.getByRole("region", { name: "Task Second" }).waitFor();
    await expect.poll(tasks).toEqual(["Task First", "Task Second"]);
  });

  it("asks also when the connection is open and the server is silent", async () => {
    process.kill(fixture.pid(), "SIGSTOP");
    try {
      await addTask("Fourth");
      await page.waitForTimeout(1500);
      await leave();
      await question().getByRole("heading", { name: "1 change is not saved yet" }).waitFor();
      await press("Stay here");
    } finally {
      process.kill(fixture.pid(), "SIGCONT");
    }
    await expect.poll(stored).toEqual(["First", "Second", "Fourth"]);
  });

  it("asks when the server has refused an edit meanwhile, says which and why, and never that all is saved", async () => {
    const held: (() => void)[] = [];
    let holds = false;
    const second = await page.context().newPage();
    await second.routeWebSocket(/\/api\/v1\/stream/, (socket) => {
      const server = socket.connectToServer();
      socket.onMessage((message) => {
        const send = () => server.send(message);
        if (holds) held.push(send);
        else send();
      });
    });
    await second.goto(`${fixture.url}/one/?edit=left`);
    await second.getByRole("region", { name: "Task First" }).getByRole("button", { name: /First/ }).click();
    holds = true;
    await second.getByRole("textbox", { name: "Name" }).fill("Renamed");
    await second.keyboard.press("Enter");
    await second.getByRole("region", { name: "Task Renamed" }).waitFor();
    await second.waitForTimeout(1500);
    await second.getByRole("link", { name: "RACE One" }).click();
    const asked = second.getByRole("alertdialog");
    await asked.getByRole("heading", { name: "1 change is not saved yet" }).waitFor();
    await page.getByRole("region", { name: "Task First" }).getByRole("button", { name: /First/ }).click();
    await page.getByRole("button", { name: "Remove", exact: true }).click();
    await expect.poll(stored).toEqual(["Second", "Fourth"]);
    holds = false;
    held.forEach((send) => send());
    await asked.getByRole("heading", { name: "1 change was not taken" }).waitFor();
    await expect.poll(() => asked.getByRole("list", { name: "What was refused, and why" }).getByRole("listitem").count()).toBe(1);
    expect(await asked.innerText()).not.toContain("All is saved now");
    expect(await findings(second)).toEqual([]);
    await fixture.screenshot("one-leaving-refused", second);
    await asked.getByRole("button", { name: "Stay here" }).click();
    await second.getByRole("link", { name: "RACE One" }).click();
    await asked.getByRole("heading", { name: "1 change was not taken" }).waitFor();
    await asked.getByRole("button", { name: "Leave without it" }).click();
    await second.getByRole("heading", { name: "What shall the robot do?" }).waitFor();
    await second.close();
  });
});
