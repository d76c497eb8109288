// What comes on a page by itself while the robot is moved by hand, and goes again: the robot is slower, somebody asks for the controls.
import type { Locator, Page } from "playwright-core";
import type { Fixture } from "./fixture";
import { kPatience } from "./patience";

export interface Coming {
  readonly what: string;
  readonly comes: () => Promise<void>;
  readonly goes: () => Promise<void>;
}

/** The server tells `page` from now on that the robot has the speed of the result; a run that is made lets the page ask for it. */
export async function slowRobot(fixture: Fixture, page: Page, document: string): Promise<Coming> {
  let share = 1;
  const told = /\/api\/v1\/services\/robot\/calls$/;
  await page.route(told, async (route) => {
    const response = await route.fetch();
    const json = (await response.json().catch(() => undefined)) as { readonly result?: { readonly speed_override?: number } } | undefined;
    // The page has gone.
    if (json === undefined) return;
    if (json.result?.speed_override === undefined) await route.fulfill({ response });
    else await route.fulfill({ response, json: { ...json, result: { ...json.result, speed_override: share } } });
  });
  const sign = page.locator(".speed-sign");
  const tell = async (next: number) => {
    share = next;
    await fixture.send("POST", "/cores", { document });
  };
  return {
    what: "the speed",
    comes: async () => {
      await tell(0);
      await sign.waitFor();
    },
    goes: async () => {
      await tell(1);
      await sign.waitFor({ state: "detached" });
      await page.unroute(told);
    },
  };
}

/** A pointer comes down while a key holds the button `held`: nothing moves, and the page says why until the key holds it again. */
export function secondFinger(page: Page, held: Locator): Coming {
  const said = page.getByText(/^Not moved: more than one finger/);
  return {
    what: "the message about two fingers",
    comes: async () => {
      await held.focus();
      await page.keyboard.down("Space");
      await page.evaluate(() => void document.body.dispatchEvent(new PointerEvent("pointerdown", { pointerId: 77, bubbles: true })));
      await said.waitFor();
      await page.keyboard.up("Space");
    },
    goes: async () => {
      await held.press("Space", { delay: 200 });
      await said.waitFor({ state: "detached" });
    },
  };
}

/** Of a person at another page, who asks no more then. */
export async function otherPerson(fixture: Fixture, page: Page): Promise<Coming> {
  const other = await fixture.openPage({ width: 1366, height: 768 });
  other.setDefaultTimeout(kPatience);
  await other.goto(`${fixture.url}/pro/?below=manual`);
  const panel = other.getByRole("region", { name: "Manual control" });
  const request = page.getByRole("group", { name: "Request for the controls" });
  return {
    what: "who asks for the controls",
    comes: async () => {
      await panel.getByRole("button", { name: "Ask to take over" }).click();
      await request.waitFor();
    },
    goes: async () => {
      await panel.getByRole("button", { name: "Ask no more" }).click();
      await request.waitFor({ state: "detached" });
      await other.context().close();
    },
  };
}

/** The buttons of these names are where they were while each of these is there, and afterwards. `prepare`: the page has the controls then, also if it has lost them meanwhile. */
export async function expectStill(page: Page, names: readonly string[], prepare: () => Promise<unknown>, ...all: readonly Coming[]): Promise<void> {
  const boxes = () => Promise.all(names.map((name) => page.getByRole("button", { name, exact: true }).boundingBox()));
  await prepare();
  const before = await boxes();
  expect(before).not.toContain(null);
  for (const { what, comes, goes } of all) {
    await prepare();
    await comes();
    expect(await boxes(), `${what} has come`).toEqual(before);
    await goes();
    // Another page, which has been opened for it, may have taken so long that this one has lost the controls.
    await prepare();
    expect(await boxes(), `${what} has gone`).toEqual(before);
  }
}
