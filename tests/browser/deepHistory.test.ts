// A deep history on the expert page: the sign of its dispatchers, and a task that is interrupted goes on where it was.
import type { Page } from "playwright-core";
import { openFixture, type Fixture } from "./fixture";

const port = (name: string, to: string) => ({ name, when: "False", to });
const kTask = {
  rcm: 1,
  name: "interrupted",
  root: {
    state: "Root",
    children: [
      {
        state: "Task",
        children: [
          { state: "Pick", children: [{ state: "Approach", ports: [port("there", "Grasp")] }, { state: "Grasp" }], first: "Approach" },
          { state: "Home", keep: [], children: [{ state: "Up" }], first: "Up" },
        ],
        first: "Pick",
        ports: [port("hit", "Collision")],
        oracle: { kind: "history", resume: ["hit"], deep: true },
      },
      { state: "Collision", ports: [port("back", "Task")] },
    ],
    first: "Task",
  },
};

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
  await fixture.send("PUT", "/documents/interrupted", kTask);
  await fixture.send("POST", "/cores", { document: "interrupted" });
  await page.goto(`${fixture.url}/pro/`);
  await page.getByRole("group", { name: "State Root/Task", exact: true }).waitFor();
});
afterAll(() => fixture.close());

const state = (path: string) => page.getByRole("group", { name: `State ${path}`, exact: true });
const sign = (path: string) => page.getByRole("button", { name: `Select ${path}/Dispatcher`, exact: true });
const force = (id: string, path: string, name: string) => fixture.send("POST", `/cores/${id}/force`, { path, scope: "port", name });

describe("a deep history", () => {
  it("has the sign of UML at its dispatcher and at those of the states inside that go on, too", async () => {
    await sign("Root/Task").waitFor();
    expect(await sign("Root/Task").innerText()).toBe("H*");
    expect(await sign("Root/Task/Pick").innerText()).toBe("H*");
    expect(await state("Root/Task").innerText()).toContain("oracle deep history");
    expect(await state("Root/Task").innerText()).not.toContain("last_active");
    await state("Root/Task/Home").waitFor();
    expect(await sign("Root/Task/Home").count()).toBe(0);
    await fixture.screenshot("deep-history");
  });

  it("enters the state again in which the task was interrupted", async () => {
    const id = new URL(page.url()).searchParams.get("run") ?? "";
    await page.getByRole("button", { name: "Start", exact: true }).click();
    await expect.poll(() => state("Root/Task/Pick/Approach").getAttribute("class")).toContain("is-active");
    await force(id, "Root/Task/Pick/Approach", "there");
    await force(id, "Root/Task", "hit");
    await expect.poll(() => state("Root/Collision").getAttribute("class")).toContain("is-active");
    await force(id, "Root/Collision", "back");
    await expect.poll(() => state("Root/Task/Pick/Grasp").getAttribute("class")).toContain("is-active");
    await fixture.screenshot("deep-history-goes-on");
  });
});
