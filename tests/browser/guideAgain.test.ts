// RACE-One: the guide says what has failed when it makes the application, and a second try makes it, in one document. On the real server.
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
  fixture.allowError(/Failed to load resource/);
});
afterAll(() => fixture.close());

const button = (name: string) => page.getByRole("button", { name, exact: true });
const problem = () => page.getByRole("alert").filter({ hasText: "That did not work" });
const steps = () => page.getByRole("list", { name: "What the robot will do" }).getByRole("listitem");
const documents = async (): Promise<readonly string[]> => {
  const { documents: all } = (await fixture.send("GET", "/documents")) as { readonly documents: readonly { readonly name: string }[] };
  return all.map(({ name }) => name).filter((name) => name.startsWith("first-application"));
};
const edit = () => new URL(page.url()).searchParams.get("edit");
const kStoring = /\/api\/v1\/documents\/first-application(-\d)?\?/;

/** The step of the guide that makes the application, before it is made. */
async function toMake(): Promise<void> {
  await page.goto(`${fixture.url}/one/?guide=application&part=home&place=home`);
  await button("Make the application").waitFor();
  await page.getByText("Connected", { exact: true }).waitFor();
}

describe("making the application of the guide", () => {
  it("says that the server is not there, and is done by a second try", async () => {
    await toMake();
    await page.route(kStoring, (route) => route.abort());
    await button("Make the application").click();
    await problem().waitFor();
    await expect.poll(() => button("Next").isDisabled()).toBe(true);
    expect([edit(), await documents()]).toEqual([null, []]);
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("one-guide-again");
    await page.unroute(kStoring);
    await button("Try again").click();
    await steps().nth(1).waitFor();
    await expect.poll(async () => [edit(), await documents(), await problem().count()]).toEqual(["first-application", ["first-application"], 0]);
    await expect.poll(() => button("Next").isEnabled()).toBe(true);
  });

  it("finds the document whose storing had no answer, and makes no second one", async () => {
    await toMake();
    await page.route(kStoring, async (route) => {
      await route.fetch();
      await route.abort();
    });
    await button("Make the application").click();
    await problem().waitFor();
    await page.unroute(kStoring);
    expect(await documents()).toEqual(["first-application", "first-application-2"]);
    await button("Try again").click();
    await steps().nth(1).waitFor();
    await expect.poll(async () => [edit(), await documents()]).toEqual(["first-application-2", ["first-application", "first-application-2"]]);
  });

  it("takes another name where somebody has taken its own meanwhile", async () => {
    await toMake();
    await fixture.send("PUT", "/documents/first-application-3", { rcm: 1, name: "first-application-3", root: { state: "Application" } });
    await button("Make the application").click();
    await steps().nth(1).waitFor();
    await expect.poll(() => edit()).toBe("first-application-4");
  });

  it("goes on with an application that was made partly", async () => {
    await fixture.send("PUT", "/documents/first-application-5", { rcm: 1, name: "first-application-5", root: { state: "Application", meta: { id: "root" } } });
    await page.goto(`${fixture.url}/one/?guide=application&part=home&place=home&edit=first-application-5`);
    await page.getByRole("alert").filter({ hasText: "The application is not complete" }).waitFor();
    await expect.poll(() => button("Next").isDisabled()).toBe(true);
    const before = await documents();
    await button("Try again").click();
    await steps().nth(1).waitFor();
    await expect.poll(async () => [edit(), await steps().count(), await documents()]).toEqual(["first-application-5", 2, before]);
  });
});
