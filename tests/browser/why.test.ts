// Explanations of conditions that nothing can change: the panel says that they are constant, and why.
import type { Page } from "playwright-core";
import { openFixture, type Fixture } from "./fixture";

const kTask = {
  rcm: 1,
  name: "constant",
  root: {
    state: "Root",
    children: [
      { state: "A", ports: [{ name: "always", when: "True", to: "B" }, { name: "never", when: "not True" }] },
      { state: "B", ports: [{ name: "done", when: "1 > 2" }] },
    ],
    first: "A",
  },
};

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
  await fixture.send("PUT", "/documents/constant", kTask);
  await fixture.send("POST", "/cores", { document: "constant" });
  await page.goto(`${fixture.url}/pro/`);
  await page.getByRole("group", { name: "State Root/A" }).waitFor();
});
afterAll(() => fixture.close());

const ask = (port: string) => page.getByRole("button", { name: `Port ${port}`, exact: true }).click();
const told = (region: string) => expect.poll(() => page.getByRole("region", { name: region, exact: true }).innerText());

describe("why, of a constant condition", () => {
  it("says that it is always true, and that its state alone is missing", async () => {
    await ask("Root/A.always");
    await told("Why").toMatch(/Cannot fire: its state is not active[^]*The condition is constant: it reads no .* always true/);
    expect(await page.getByRole("list", { name: "Atoms of the condition" }).getByRole("listitem").allInnerTexts()).toEqual([
      expect.stringMatching(/True\s+true\s+a constant: it reads nothing/),
    ]);
    await fixture.screenshot("constant");
  });

  it("says of a port that has fired that nothing but its state was needed", async () => {
    await page.getByRole("button", { name: "Macro step" }).click();
    await expect.poll(() => page.getByRole("treeitem", { name: "Root/B", exact: true }).getAttribute("data-active")).toBe("true");
    await told("Why it fired").toMatch(/Fired in macro step 1[^]*The condition is constant/);
  });

  it("names no atom to change for a port that never fires", async () => {
    await ask("Root/B.done");
    await told("Why").toMatch(/Never fires[^]*always false. The port can never fire/);
    await told("Why").not.toMatch(/It fires when|would fire/);
    await ask("Root/A.never");
    await told("Why").toMatch(/Never fires/);
  });
});
