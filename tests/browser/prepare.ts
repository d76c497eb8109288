// What is to be done before the robot is moved by hand in RACE-One.
import type { Locator, Page } from "playwright-core";

/** Takes the controls and turns to programming mode where `within` says so, also again: a machine that has much to do may lose them. */
export async function prepareToMove(page: Page, within: Page | Locator = page): Promise<void> {
  const before = within.getByRole("region", { name: "Before you move the robot" });
  if ((await before.count()) === 0) return;
  const take = before.getByRole("button", { name: "Take the controls" });
  if ((await take.count()) > 0) await take.click();
  await page.getByText("You have the controls").waitFor();
  const programming = before.getByRole("button", { name: "Programming" });
  if ((await programming.count()) > 0) await programming.click();
  await before.waitFor({ state: "detached" });
}
