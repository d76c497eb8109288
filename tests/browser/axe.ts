// Runs axe-core in a page and tells what is inaccessible in it.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { AxeResults } from "axe-core";
import type { Page } from "playwright-core";
import { project } from "./fixture";

const source = readFileSync(join(project, "web/node_modules/axe-core/axe.min.js"), "utf8");

/** Until what flashes, fades or moves in the page now is at its end: a colour on its way to another would be a finding. */
const atRest = (page: Page): Promise<void> =>
  page.evaluate(async () => {
    const ends = document.getAnimations().filter(({ playState, effect }) => playState === "running" && Number.isFinite(Number(effect?.getComputedTiming().endTime)));
    await Promise.all(ends.map(({ finished }) => finished.catch(() => undefined)));
  });

/** What axe-core finds in the page as it is shown now, each `rule: element (what to mend)`. */
export async function findings(page: Page): Promise<readonly string[]> {
  await atRest(page);
  // By the debugger: the server's rules forbid scripts inside a page.
  if (!(await page.evaluate(() => "axe" in globalThis))) await page.evaluate(source);
  const { violations } = await page.evaluate<Pick<AxeResults, "violations">>("axe.run({ resultTypes: ['violations'] })");
  return violations.flatMap(({ id, nodes }) => nodes.map(({ target, failureSummary }) => `${id}: ${target.join(" ")} (${failureSummary?.split("\n").slice(1).join(" ").trim() ?? ""})`));
}
