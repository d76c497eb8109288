// What is live over the still drawing is painted some times a second, less often while the view moves, and at once when it comes to rest.
import { describe, expect, it } from "vitest";
import { isLiveDue, kRest } from "../../shared/drawing/livePace";

/** When it is painted, in frames of 10 ms, while the view moves from `from` to `to` [ms]. */
function paintings(until: number, from: number, to: number): readonly number[] {
  const painted = [-1000];
  for (let now = 0; now <= until; now += 10) {
    const moved = now < from ? -1000 : Math.min(now, to);
    if (isLiveDue(now, painted.at(-1) ?? 0, moved)) painted.push(now);
  }
  return painted.slice(1);
}

describe("the pace of what is live", () => {
  it("is that of a film at rest", () => {
    expect(paintings(120, 1000, 1000)).toEqual([0, 30, 60, 90, 120]);
  });
  it("is ten in a second while the view moves, and that of rest as soon as it has come to rest", () => {
    expect(paintings(600, 50, 400)).toEqual([0, 30, 130, 230, 330, 430, 400 + kRest, 550, 580]);
  });
  it("is at once at the end of a short movement", () => {
    expect(paintings(200, 10, 10)).toEqual([0, 100, 130, 160, 190]);
  });
});
