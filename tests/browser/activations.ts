// Records which states of the drawing become active.
import type { Page } from "playwright-core";

/** Starts to record the states of the drawing in the order in which they become active. */
export async function noteActivations(page: Page): Promise<void> {
  await page.evaluate(() => {
    const order: string[] = [];
    const note = (element: Element) => {
      const path = element.getAttribute("data-path");
      if (path !== null && element.getAttribute("data-active") === "true" && !order.includes(path)) order.push(path);
    };
    const canvas = document.querySelector(".canvas");
    if (canvas === null) throw new Error("nothing is drawn");
    new MutationObserver((changes) => changes.forEach((change) => change.target instanceof Element && note(change.target))).observe(canvas, {
      subtree: true,
      attributeFilter: ["data-active"],
    });
    Object.assign(window, { activations: order });
  });
}

export const activations = (page: Page): Promise<readonly string[]> =>
  page.evaluate(() => {
    const noted: unknown = Reflect.get(window, "activations");
    return Array.isArray(noted) ? noted.map(String) : [];
  });
