import { describe, expect, it } from "vitest";
import { isWayOut } from "../../shared/display/answers";

describe("an answer", () => {
  it("that ends what is going on is a way out", () => expect(["Abort", "cancel", "Stop the task", "Give up"].filter(isWayOut)).toHaveLength(4));
  it("that goes on is none, nor one that only begins like it", () => expect(["Continue", "Skip", "OK", "Endless", "Stopper", "Error list", "Do not abort"].filter(isWayOut)).toEqual([]));
});
