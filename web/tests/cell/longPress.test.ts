import { describe, expect, it } from "vitest";
import { createLongPress } from "../../shared/cell/longPress";

/** A press with a clock of the test. */
function press() {
  const pressed: (readonly [number, number])[] = [];
  const due: (() => void)[] = [];
  const after = (_: number, act: () => void) => {
    due.push(act);
    return () => void due.splice(due.indexOf(act), 1);
  };
  const fingers = createLongPress({ after, onPress: (x, y) => pressed.push([x, y]) });
  return { ...fingers, pressed, pass: () => due.splice(0).forEach((act) => act()) };
}
const finger = (x: number, y: number, id = 1) => ({ id, x, y });

describe("createLongPress", () => {
  it("is reported at the position of a finger that stays, with small movements", () => {
    const { down, move, pass, pressed } = press();
    down(finger(100, 50));
    move(finger(104, 47));
    expect(pressed).toEqual([]);
    pass();
    expect(pressed).toEqual([[100, 50]]);
  });
  it("is cancelled when the finger moves away, even if it returns", () => {
    const { down, move, pass, pressed } = press();
    down(finger(100, 50));
    move(finger(111, 50));
    move(finger(100, 50));
    pass();
    expect(pressed).toEqual([]);
  });
  it("is cancelled when the finger is lifted early", () => {
    const { down, up, pass, pressed } = press();
    down(finger(100, 50));
    up(1);
    pass();
    expect(pressed).toEqual([]);
  });
  it("needs a single finger, also after one of two is lifted", () => {
    const { down, up, pass, pressed } = press();
    down(finger(100, 50));
    down(finger(200, 50, 2));
    pass();
    up(1);
    pass();
    expect(pressed).toEqual([]);
    up(2);
    down(finger(70, 70, 3));
    pass();
    expect(pressed).toEqual([[70, 70]]);
  });
  it("ignores a finger that only moves", () => {
    const { down, move, pass, pressed } = press();
    down(finger(100, 50));
    move(finger(190, 50, 2));
    pass();
    expect(pressed.length).toBe(1);
  });
});
