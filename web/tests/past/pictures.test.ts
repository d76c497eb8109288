// The picture of a moment is the newest one that had been taken.
import { describe, expect, it } from "vitest";
import { listedUpTo, pictureAt } from "../../shared/past/pictures";

const pictures = [2, 2, 5].map((step, number) => ({ number, service: "camera", step, time: number / 2 }));

describe("the picture at a macro step", () => {
  it("is none before the first one", () => expect(pictureAt(pictures, 1)).toBeUndefined());
  it("is the newest of its step", () => expect(pictureAt(pictures, 2)?.number).toBe(1));
  it("is the newest one before it where none was taken", () => expect(pictureAt(pictures, 4)?.number).toBe(1));
  it("is the last one after all", () => expect(pictureAt(pictures, 99)?.number).toBe(2));
  it("may come later while the run goes on: a list is complete up to its step, and once the run is over for good", () => {
    expect((["running", "interrupted", "ended", "faulted", "aborted"] as const).map((status) => listedUpTo({ status }, 7))).toEqual([7, 7, Infinity, Infinity, Infinity]);
  });
  it("is none of a run without any", () => expect(pictureAt([], 3)).toBeUndefined());
});
