// What is to be done before the robot is moved by hand in RACE-One, and afterwards: also again, as a machine that has much to do may keep a page from
// its signs of life, which then loses the controls.
import type { Locator, Page } from "playwright-core";
import { kSoon } from "./patience";

const kTries = 5;
/** Until it is looked whether the page has lost the controls [ms]. */
const kPatience = 8000;

type Press = (on: Locator) => Promise<unknown>;
const click: Press = (on) => on.click(kSoon);
/** The page may have lost the controls, and the button with them. */
const ifThere = async (on: Locator, press: Press): Promise<void> => void ((await on.count()) > 0 && (await press(on.first()).catch(() => undefined)));

/**
 * Does `act`, which needs the controls; again if the page has lost them meanwhile. `take`: takes them, if the page does not have them. `mark`: is on
 * the page as long as it has them.
 */
export async function holding(take: () => Promise<unknown>, mark: Locator, act: () => Promise<unknown>): Promise<void> {
  for (let tries = 1; ; tries++) {
    await take();
    try {
      await act();
      return;
    } catch (error) {
      // The page is told a moment after the server has taken them.
      const isLost = await mark.waitFor({ state: "hidden", timeout: 3000 }).then(() => true, () => false);
      if (!isLost || tries === kTries) throw error;
    }
  }
}

/** Takes the controls and turns to programming mode where `within` says so. */
export async function prepareToMove(page: Page, within: Page | Locator = page, press = click): Promise<void> {
  const before = within.getByRole("region", { name: "Before you move the robot" });
  for (let tries = 1; (await before.count()) > 0; tries++)
    try {
      await ifThere(before.getByRole("button", { name: "Take the controls" }), press);
      await page.getByText("You have the controls", { exact: true }).waitFor(kSoon);
      await ifThere(before.getByRole("button", { name: "Programming" }), press);
      await before.waitFor({ state: "detached", timeout: kPatience });
    } catch (error) {
      if (tries === kTries) throw error;
    }
}

/** From programming mode, which the page says, back to execution mode, in which a run goes by itself, whoever has the controls; gives them back. */
export async function returnToExecution(page: Page, press = click): Promise<void> {
  const mode = page.getByRole("region", { name: "Mode", exact: true });
  for (let tries = 1; (await mode.count()) > 0; tries++)
    try {
      await ifThere(page.getByRole("button", { name: "Take the controls", exact: true }), press);
      await page.getByText("You have the controls", { exact: true }).waitFor(kSoon);
      await press(mode.getByRole("button", { name: "Execution" }));
      await mode.waitFor({ state: "detached", timeout: kPatience });
    } catch (error) {
      if (tries === kTries) throw error;
    }
  await ifThere(page.getByRole("button", { name: "Give back", exact: true }), press);
}
