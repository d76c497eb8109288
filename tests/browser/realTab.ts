// A page in a tab of its own window, as a person opens it. Playwright's own pages take part in no hiding: it emulates their focus.
import type { Browser, CDPSession } from "playwright-core";
import { kPatience } from "./patience";

interface Answer {
  readonly id: number;
  readonly result?: unknown;
  readonly error?: { readonly message: string };
}

export interface RealTab {
  /** The value of a JavaScript expression in the page; a promise is waited for. */
  readonly evaluate: (expression: string) => Promise<unknown>;
  /** Waits until an expression is true. */
  readonly until: (expression: string) => Promise<void>;
  /** Presses the middle of the first element whose name is this one, with the left button of the mouse, or a finger where the tab has touch. */
  readonly press: (label: string) => Promise<void>;
  readonly release: (label: string) => Promise<void>;
  /** Shows another tab of the window, which hides this one. */
  readonly showAnother: () => Promise<void>;
  readonly minimise: () => Promise<void>;
  readonly freeze: () => Promise<void>;
  /** Ends the process that draws the page. */
  readonly crash: () => Promise<void>;
  /** With all tabs of its window. */
  readonly close: () => Promise<void>;
}

const named = (label: string): string => `document.querySelector('[aria-label=${JSON.stringify(label)}]')`;

/** Requires Chromium. `touch`: it is pressed by fingers, not by a mouse. */
export async function openRealTab(browser: Browser, url: string, touch = false): Promise<RealTab> {
  const devtools = await browser.newBrowserCDPSession();
  const { targetId } = await devtools.send("Target.createTarget", { url, newWindow: true, width: 1366, height: 768 });
  const { sessionId } = await devtools.send("Target.attachToTarget", { targetId, flatten: false });
  const targets = [targetId];
  const send = speaker(devtools, sessionId);

  async function evaluate(expression: string): Promise<unknown> {
    const answer = (await send("Runtime.evaluate", { expression, returnByValue: true, awaitPromise: true })) as { readonly result: { readonly value?: unknown }; readonly exceptionDetails?: { readonly text: string } };
    if (answer.exceptionDetails !== undefined) throw new Error(`${expression}: ${answer.exceptionDetails.text}`);
    return answer.result.value;
  }
  async function until(expression: string): Promise<void> {
    // A page that is being opened has nothing to evaluate it in.
    const isTrue = () => evaluate(`Boolean(${expression})`).catch(() => false);
    for (const end = Date.now() + kPatience; (await isTrue()) !== true; await new Promise((resolve) => setTimeout(resolve, 50)))
      if (Date.now() > end) throw new Error(`not true: ${expression}`);
  }
  /** In view, as a finger reaches nothing else. */
  const middleOf = (label: string) =>
    evaluate(`(() => { const found = ${named(label)}; found.scrollIntoView({ block: "nearest" }); const { x, y, width, height } = found.getBoundingClientRect(); return { x: x + width / 2, y: y + height / 2 }; })()`) as Promise<Readonly<Record<"x" | "y", number>>>;
  if (touch) await send("Emulation.setTouchEmulationEnabled", { enabled: true, maxTouchPoints: 5 });
  return {
    evaluate,
    until,
    press: async (label) => {
      const place = await middleOf(label);
      await (touch ? send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [place] }) : send("Input.dispatchMouseEvent", { type: "mousePressed", ...place, button: "left", buttons: 1, clickCount: 1 }));
    },
    release: async (label) => {
      const place = await middleOf(label);
      await (touch ? send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] }) : send("Input.dispatchMouseEvent", { type: "mouseReleased", ...place, button: "left", buttons: 1, clickCount: 1 }));
    },
    showAnother: async () => void targets.push((await devtools.send("Target.createTarget", { url: "about:blank" })).targetId),
    minimise: async () => {
      const { windowId } = await devtools.send("Browser.getWindowForTarget", { targetId });
      await devtools.send("Browser.setWindowBounds", { windowId, bounds: { windowState: "minimized" } });
    },
    freeze: async () => void (await send("Page.setWebLifecycleState", { state: "frozen" })),
    // It answers no more.
    crash: async () => void (await Promise.race([send("Page.crash", {}), devtools.send("Target.getTargets")])),
    close: async () => {
      // Again, there is nothing to close.
      for (const target of targets.splice(0)) await devtools.send("Target.closeTarget", { targetId: target }).catch(() => undefined);
      await devtools.detach().catch(() => undefined);
    },
  };
}

/** Commands to one target of a session of the whole browser. */
function speaker(devtools: CDPSession, sessionId: string) {
  const waiting = new Map<number, (answer: Answer) => void>();
  let last = 0;
  devtools.on("Target.receivedMessageFromTarget", ({ message }) => {
    const answer = JSON.parse(message) as Answer;
    waiting.get(answer.id)?.(answer);
    waiting.delete(answer.id);
  });
  return async (method: string, params: Readonly<Record<string, unknown>>): Promise<unknown> => {
    const id = ++last;
    const answered = new Promise<Answer>((resolve) => waiting.set(id, resolve));
    await devtools.send("Target.sendMessageToTarget", { sessionId, message: JSON.stringify({ id, method, params }) });
    const { result, error } = await answered;
    if (error !== undefined) throw new Error(`${method}: ${error.message}`);
    return result;
  };
}
