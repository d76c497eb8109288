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
    await expect.poll(() => page.getByRole("list", { name: "Atoms of the condition" }).getByRole("listitem").allInnerTexts()).toEqual([
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

describe("why, of actions and parameters", () => {
  const kPick = {
    rcm: 1,
    name: "asked",
    root: {
      state: "Root",
      variables: [{ name: "n", initial: 0 }],
      actions: [{ when: "var.n == 0", do: "var.n = 2" }, { when: "var.n > 5", do: "pass" }],
      first: "A",
      children: [
        { state: "A", ports: [{ name: "go", when: "True", to: "B" }] },
        { state: "B", parameters: [{ name: "width", from: "var.n * 3" }], ports: [{ name: "done", when: "par.width > 100" }] },
      ],
      ports: [{ name: "over", when: "chi.B.port.done" }],
    },
  };
  const why = (name: string) => page.getByRole("button", { name: `Why ${name}`, exact: true });

  it("says what an action waits for, and what the next activation would give a parameter", async () => {
    await fixture.send("PUT", "/documents/asked", kPick);
    await fixture.send("POST", "/cores", { document: "asked" });
    await page.goto(`${fixture.url}/pro/?run=2&sel=Root`);
    await why("action 2 is executed or not").click();
    await told("Why").toMatch(/Not executed: its state is not active/);
    await page.getByRole("button", { name: "Micro step" }).click();
    await told("Why").toMatch(/Not executed\s+It is executed when var.n > 5 becomes true[^]*var.n is 2[^]*alone would execute this action[^]*now, when its turn comes in the next micro step/);
    await expect.poll(() => new URL(page.url()).searchParams.get("why")).toBe("action.1");
    await page.getByRole("treeitem", { name: "Root/B", exact: true }).click();
    await why("width has its value").click();
    await told("Why").toMatch(/An activation would give it 0[^]*var.n \* 3\s+var.n is 0/);
    await fixture.screenshot("why_parameter");
  });

  it("tells where the value came from, as things were when its turn came", async () => {
    await page.getByRole("button", { name: "Macro step" }).click();
    await told("Where its value came from").toMatch(/Resolved in macro step 1, micro step \d[^]*Its expression gave 6[^]*var.n is 2/);
    await page.getByRole("region", { name: "Where its value came from" }).getByRole("button", { name: "Show the derivation" }).click();
    await expect.poll(() => page.getByRole("region", { name: "Inference" }).innerText()).toMatch(/Resolve/);
  });

  it("is at the same place when the page is opened again, and leads to the ports that a condition reads", async () => {
    await page.reload();
    await told("Where its value came from").toMatch(/Its expression gave 6/);
    await page.goto(`${fixture.url}/pro/?run=2&sel=Root&why=action.0`);
    await told("Why it was executed").toMatch(/Executed in macro step 1, micro step 2[^]*its condition was true[^]*var.n is 0/);
    await fixture.screenshot("why_action");
    await page.goto(`${fixture.url}/pro/?run=2&sel=Root.over`);
    await page.getByRole("list", { name: "Atoms of the condition" }).getByRole("button", { name: "Root/B.done" }).click();
    await expect.poll(() => new URL(page.url()).searchParams.get("sel")).toBe("Root/B.done");
  });
});
