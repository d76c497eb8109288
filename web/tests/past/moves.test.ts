import { describe, expect, it } from "vitest";
import { momentOf, momentText, type Wanted } from "../../shared/past/moment";
import { moved, type Move, type Target } from "../../shared/past/moves";

/** Micro steps of each macro step of a run. */
const kRun = [3, 0, 2];
const last = kRun.length;

/** What the server answers. */
const found = ({ step, micro = Infinity }: Wanted) => {
  const count = kRun[step - 1] ?? 0;
  return { step, micro: Math.min(micro, count), complete: micro >= count };
};
/** All moments that one comes through from here. */
function way(move: Move, from: Wanted): readonly string[] {
  const target: Target | undefined = moved(move, found(from), last);
  if (target === undefined) return [];
  return target === "present" ? ["present"] : [momentText(found(target)), ...way(move, target)];
}

describe("a moment", () => {
  it("is read as it is written", () => {
    expect(momentOf(momentText({ step: 12, micro: 3 }))).toEqual({ step: 12, micro: 3 });
    expect(momentOf("12")).toEqual({ step: 12 });
  });
  it.each([undefined, "", "0.1", "-1", "1.", ".3", "1.x", "1.2.3", "01.1", "99999999999.0"])("is not %s", (text) => expect(momentOf(text)).toBeUndefined());
});

describe("moved", () => {
  it("goes back through every micro step, over the ends of macro steps, to the beginning", () => {
    expect(way("back", { step: 3 })).toEqual(["3.1", "3.0", "2.0", "1.3", "1.2", "1.1", "1.0"]);
  });
  it("goes forward through the same moments, to the present", () => {
    expect(way("forward", { step: 1, micro: 0 })).toEqual(["1.1", "1.2", "1.3", "2.0", "3.0", "3.1", "3.2", "present"]);
  });
  it("goes by the ends of macro steps", () => {
    expect(way("back_step", { step: 3 })).toEqual(["2.0", "1.3", "1.0"]);
    expect(way("forward_step", { step: 1, micro: 0 })).toEqual(["1.3", "2.0", "3.2", "present"]);
  });
});
