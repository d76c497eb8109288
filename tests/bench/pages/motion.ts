// A hand that moves the drawing: drags and wheel steps about as often as a mouse sends them.
import type { Page } from "playwright-core";

/** Between two events of the mouse [ms]. */
const kEvent = 16;

async function middleOfCanvas(page: Page): Promise<{ readonly x: number; readonly y: number }> {
  const box = await page.locator(".painted").boundingBox();
  if (box === null) throw new Error("the drawing is not painted");
  return { x: Math.round(box.x + box.width / 2), y: Math.round(box.y + box.height / 2) };
}

/** Calls `step` so often, each time after the last one and its time. */
async function repeat(seconds: number, step: (share: number) => Promise<void>): Promise<void> {
  const begun = performance.now();
  for (let now = begun, next = begun; now - begun < seconds * 1000; now = performance.now()) {
    await step((now - begun) / (seconds * 1000));
    next = Math.max(next + kEvent, performance.now());
    await new Promise((resolve) => setTimeout(resolve, next - performance.now()));
  }
}

/** Drags the drawing round and round, with the middle button: the left one drags states. */
export async function pan(page: Page, seconds: number): Promise<void> {
  const { x, y } = await middleOfCanvas(page);
  await page.mouse.move(x, y);
  await page.mouse.down({ button: "middle" });
  await repeat(seconds, async (share) => {
    const turn = share * seconds * Math.PI;
    await page.mouse.move(x + 350 * Math.sin(turn), y + 250 * (1 - Math.cos(turn)) - 100);
  });
  await page.mouse.up({ button: "middle" });
}

/** Zooms in and out again. */
export async function zoom(page: Page, seconds: number): Promise<void> {
  const { x, y } = await middleOfCanvas(page);
  await page.mouse.move(x, y);
  await repeat(seconds, (share) => page.mouse.wheel(0, Math.floor(share * 4) % 2 === 0 ? -40 : 40));
}
