// On a phone, the page ends where the bar of STOP begins: the height that pages leave for it is that of its parts.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";

const css = readFileSync(fileURLToPath(new URL("../../stop/stop.css", import.meta.url)), "utf8");
const phone = css.slice(css.indexOf("@media (max-width: 760px)"));

/** The declarations of a rule of a phone. */
function rule(selector: string): string {
  const line = phone.split("\n").find((each) => each.trim().startsWith(`${selector} {`));
  if (line === undefined) throw new Error(`no rule ${selector}`);
  return line;
}
const pixels = (text: string, pattern: RegExp): number => Number(pattern.exec(text)?.[1] ?? "NaN");

describe("the bar of STOP", () => {
  it("is as high as the pages leave for it", () => {
    const bar = rule("#stop-layer");
    expect(bar).toContain("box-sizing: border-box");
    expect(bar).toContain("height: var(--stop-bottom)");
  });

  it("has the height of its border, its button and the space around that", () => {
    const left = pixels(rule("html:root"), /--stop-bottom: calc\((\d+)px \+ max\(6px, env\(safe-area-inset-bottom\)\)\)/);
    const bar = rule("#stop-layer");
    const parts = [pixels(bar, /border-top: (\d+)px/), pixels(bar, /padding: (\d+)px/), pixels(rule("#stop-layer .stop-button"), /min-height: (\d+)px/)];
    expect(parts.reduce((sum, part) => sum + part)).toBe(left);
    expect(bar).toContain("max(6px, env(safe-area-inset-bottom))");
  });
});
