// Errors on the consoles of pages: a test file fails if its pages have any that it has not allowed.
import type { BrowserContext } from "playwright-core";

/** What Chromium says of requests while there is no server. */
const kLost = /net::ERR_|WebSocket connection to/;

export class ConsoleErrors {
  private readonly found: string[] = [];
  private readonly allowed: RegExp[] = [];

  /** Notes the errors of all pages of a context, with the test that ran. */
  watch(context: BrowserContext): void {
    context.on("console", (message) => message.type() === "error" && this.note(`${message.text()} (${message.location().url})`));
    context.on("weberror", (error) => this.note(String(error.error())));
  }

  /** Allows errors that a test provokes, from now on: `TEXT (URL)`. */
  allow(error: RegExp): void {
    this.allowed.push(error);
  }

  /** Allows what a page says that has lost its server. */
  allowLost(): void {
    this.allow(kLost);
  }

  /** Throws if there was an error. */
  check(): void {
    if (this.found.length > 0) throw new Error(`errors on the consoles of the pages:\n${this.found.join("\n")}`);
  }

  private note(error: string): void {
    if (!this.allowed.some((each) => each.test(error))) this.found.push(`in "${expect.getState().currentTestName ?? "no test"}": ${error}`);
  }
}
