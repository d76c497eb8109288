// A finger on a touch screen: it taps and holds, and counts what it does.
import type { CDPSession, Locator, Page } from "playwright-core";

/** Until a tap is felt [ms]. */
const kFelt = 5000;

/**
 * Taps as a person does who looks, and taps again if nothing was pressed: Chromium takes a touch back that its page does not answer in time, which
 * happens on a machine with too much to do.
 */
export async function tap(on: Locator, options: { readonly timeout?: number } = {}): Promise<void> {
  for (let tries = 1; ; tries++) {
    await on.waitFor(options);
    const felt = await on.evaluateHandle((element) => {
      const seen = { click: false };
      // Whatever is drawn there then.
      element.ownerDocument.defaultView?.addEventListener("click", () => (seen.click = true), { capture: true, once: true });
      return seen;
    });
    await on.tap(options);
    // A page that is left by it has felt it.
    const isFelt = () => felt.evaluate(({ click }) => click).catch(() => true);
    for (const end = Date.now() + kFelt; Date.now() < end; await new Promise((resolve) => setTimeout(resolve, 20))) if (await isFelt()) return;
    if (tries === 3) throw new Error(`${String(on)} does not feel a finger`);
  }
}

export interface Finger {
  /** Taps in the middle, or at a share of the width. */
  readonly tap: (on: Locator, share?: number) => Promise<void>;
  /** Holds until `isThere`, as a person who looks. Rejects if that takes longer than `most` [ms]. */
  readonly hold: (on: Locator, isThere: () => Promise<boolean>, most?: number) => Promise<void>;
  /** Taps and holds until now. */
  readonly count: () => number;
}

export async function fingerOn(page: Page): Promise<Finger> {
  const session: CDPSession = await page.context().newCDPSession(page);
  let count = 0;
  const placeOf = async (on: Locator, share: number): Promise<{ readonly x: number; readonly y: number }> => {
    await on.scrollIntoViewIfNeeded();
    const box = await on.boundingBox();
    if (box === null) throw new Error(`${String(on)} is not on the screen`);
    return { x: box.x + box.width * share, y: box.y + box.height / 2 };
  };
  const touch = (type: "touchStart" | "touchEnd", ...touchPoints: readonly { readonly x: number; readonly y: number }[]) => session.send("Input.dispatchTouchEvent", { type, touchPoints: [...touchPoints] });
  return {
    tap: async (on, share) => {
      count++;
      if (share === undefined) {
        await tap(on);
        return;
      }
      const { x, y } = await placeOf(on, share);
      await page.touchscreen.tap(x, y);
    },
    hold: async (on, isThere, most = 30_000) => {
      count++;
      await touch("touchStart", await placeOf(on, 0.5));
      const end = Date.now() + most;
      try {
        while (!(await isThere())) if (Date.now() > end) throw new Error(`${String(on)} was held in vain`);
      } finally {
        await touch("touchEnd");
      }
    },
    count: () => count,
  };
}
