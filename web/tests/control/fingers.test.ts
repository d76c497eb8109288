// A second finger stops what moves, wherever it touches the page.
import { expect, it } from "vitest";
import { watchFingers } from "../../control/fingers";

const down = (pointerId: number) => Object.assign(new Event("pointerdown", { cancelable: true }), { pointerId });

function watched(held: number | undefined) {
  const page = new EventTarget();
  let stops = 0;
  const end = watchFingers(page, held, () => stops++);
  const touch = (finger: number): Event => {
    const event = down(finger);
    page.dispatchEvent(event);
    return event;
  };
  return { touch, end, stops: () => stops };
}

it("another finger than the one that holds the button stops", () => {
  const { touch, stops } = watched(7);
  touch(7);
  expect(stops()).toBe(0);
  touch(8);
  expect(stops()).toBe(1);
});

it("any finger stops what a key holds", () => {
  const { touch, stops } = watched(undefined);
  touch(1);
  expect(stops()).toBe(1);
});

it("what it touches gets it all the same, and nothing is watched once the button is let go of", () => {
  const { touch, end, stops } = watched(7);
  expect(touch(8).defaultPrevented).toBe(false);
  end();
  touch(8);
  expect(stops()).toBe(1);
});
