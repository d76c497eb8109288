// A card that was dragged can be tapped, clicked and pressed by a key afterwards; the click that ends a drag does nothing.
import { expect, test } from "vitest";
import { createLastPress, pressHandlers, type PressEvent } from "../../one/line/press";

const kClick = { detail: 1 };
const kByKey = { detail: 0 };

/** A card; what it is told of the end of the press that is followed. */
function card() {
  let end: ((was: boolean) => void) | undefined;
  const handlers = pressHandlers<PressEvent>(createLastPress(), (_, onEnd) => (end = onEnd));
  const by = (pointerType: string, button = 0): PressEvent => ({ pointerType, button, preventDefault: () => undefined });
  const letGo = (wasDragged: boolean) => {
    end?.(wasDragged);
    end = undefined;
  };
  return { ...handlers, by, letGo, isFollowed: () => end !== undefined };
}

test("the click that ends a drag by mouse is none, and a press without one is", () => {
  const { fromCard, isClick, by, letGo } = card();
  fromCard(by("mouse"));
  letGo(true);
  expect(isClick(kClick)).toBe(false);
  fromCard(by("mouse"));
  letGo(false);
  expect(isClick(kClick)).toBe(true);
});

test("a tap after a drag by touch selects the card", () => {
  const { fromCard, fromGrip, isClick, by, letGo } = card();
  fromGrip(by("touch"));
  letGo(true);
  fromCard(by("touch"));
  expect(isClick(kClick)).toBe(true);
});

test.each(["touch", "pen"])("a tap by %s after a drag by mouse selects the card", (pointer) => {
  const { fromCard, isClick, by, letGo } = card();
  fromCard(by("mouse"));
  letGo(true);
  fromCard(by(pointer));
  expect(isClick(kClick)).toBe(true);
});

test("a key selects the card after it was dragged", () => {
  const { fromCard, isClick, by, letGo } = card();
  fromCard(by("mouse"));
  letGo(true);
  expect(isClick(kByKey)).toBe(true);
});

test("a finger on a card scrolls, and drags at its grip", () => {
  const { fromCard, fromGrip, by, isFollowed, letGo } = card();
  fromCard(by("touch"));
  expect(isFollowed()).toBe(false);
  fromGrip(by("touch"));
  expect(isFollowed()).toBe(true);
  letGo(false);
  fromCard(by("mouse", 2));
  expect(isFollowed()).toBe(false);
});
