// Ports with a time-out (`after`): drawn as their author wrote them, and taken when the timer of the cell says so.
import type { Page } from "playwright-core";
import { openFixture, type Fixture } from "./fixture";

const kTask = {
  rcm: 1,
  name: "answer_timeout",
  root: {
    state: "Root",
    children: [
      { state: "Ask", parameters: [{ name: "timeout", value: 8 }], ports: [{ name: "late", after: "par.timeout", to: "Remind" }] },
      { state: "Remind", children: [{ state: "Sound" }], first: "Sound", ports: [{ name: "over", after: "0.25" }] },
    ],
    first: "Ask",
    ports: [{ name: "done", when: "chi.Remind.port.over" }],
  },
};

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
  await fixture.send("PUT", "/documents/answer_timeout", kTask);
  await fixture.send("POST", "/cores", { document: "answer_timeout" });
  await page.goto(`${fixture.url}/pro/`);
  await page.getByRole("group", { name: "State Root/Ask" }).waitFor();
});
afterAll(() => fixture.close());

const port = (address: string) => page.getByRole("button", { name: `Port ${address}`, exact: true });

describe("a port with a time-out", () => {
  it("is drawn with its time, and its state as the leaf that it is", async () => {
    await page.getByRole("button", { name: "Conditions", exact: true }).click();
    await expect.poll(() => port("Root/Ask.late").innerText()).toMatch(/late\s*after par.timeout s/);
    await expect.poll(() => port("Root/Remind.over").innerText()).toMatch(/over\s*after 0.25 s/);
    expect(await page.getByRole("group", { name: "State Root/Ask/After_late" }).count()).toBe(0);
    expect(await page.getByRole("group", { name: "State Root/Remind/Sound" }).count()).toBe(1);
    await fixture.screenshot("time-out");
  });

  it("fires when the timer of the cell has answered, and the task goes on", async () => {
    await page.getByRole("button", { name: "Start", exact: true }).click();
    await expect.poll(() => port("Root/Ask.late").getAttribute("class")).toContain("is-waiting");
    await port("Root/Ask.late").click();
    await page.getByText("this time 8 s").waitFor();
    await fixture.screenshot("time-out-waits");
    await expect.poll(() => page.getByRole("status", { name: "Run status" }).innerText(), { timeout: 60_000 }).toContain("done");
  });
});
