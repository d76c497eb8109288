// What the camera sees: asked once for all who ask meanwhile; what it sees no more is offered no more, and why it does not say so is told.
import { expect, test, vi } from "vitest";
import { createSight } from "../../one/step/sight";
import type { JsonValue } from "../../shared/json";

/** A service whose responses come when the test gives them. */
function service() {
  const calls: { readonly key: string; readonly operation: string; readonly resolve: (response: JsonValue) => void; readonly reject: (error: Error) => void }[] = [];
  const sight = createSight((key, operation) => new Promise<JsonValue>((resolve, reject) => calls.push({ key, operation, resolve, reject })));
  const settle = () => new Promise((resolve) => setTimeout(resolve));
  const waiting = (operation: string) => calls.filter((call) => call.operation === operation).at(-1);
  const answer = async (operation: string, response: JsonValue) => {
    waiting(operation)?.resolve(response);
    await settle();
  };
  const fail = async (operation: string, why: string) => {
    waiting(operation)?.reject(new Error(why));
    await settle();
  };
  return { sight, now: () => sight.store.get(), asked: () => calls.map(({ key, operation }) => `${key}.${operation}`), answer, fail };
}

const picture = (...labels: readonly string[]): JsonValue => ({ time: 1, objects: labels.map((label) => ({ label })) });

test("who asks while it looks gets the same answer, and who asks then a new one", async () => {
  const { sight, now, asked, answer } = service();
  for (let i = 0; i < 3; i++) sight.look("eyes");
  expect(asked()).toEqual(["eyes.labels", "eyes.look"]);
  expect(now()).toMatchObject({ isLooking: true, seen: undefined });
  await answer("look", picture("Tape"));
  expect(now()).toMatchObject({ isLooking: false, seen: ["Tape"], problem: undefined });
  sight.look("eyes");
  expect(asked()).toHaveLength(4);
  await answer("look", picture());
  expect(now().seen).toEqual([]);
});

test("what the service can find is there before the picture", async () => {
  const { sight, now, answer } = service();
  sight.look("eyes");
  await answer("labels", ["Cube", "Tape"]);
  expect(now()).toMatchObject({ isLooking: true, known: ["Cube", "Tape"] });
});

test("why it is not known is told until it is, and what was seen before is not taken for now", async () => {
  const { sight, now, answer, fail } = service();
  sight.look("eyes");
  await answer("labels", ["Cube", "Tape"]);
  await answer("look", picture("Tape"));
  sight.look("eyes");
  await fail("labels", "the service is away");
  await fail("look", "no picture has come from the camera");
  expect(now()).toEqual({ isLooking: false, seen: undefined, known: ["Cube", "Tape"], problem: "no picture has come from the camera" });
  sight.look("eyes");
  await answer("look", picture("Cube"));
  expect(now()).toMatchObject({ seen: ["Cube"], problem: undefined });
});

test("a camera that does not answer is waited for no longer than a while, and may be asked again", async () => {
  vi.useFakeTimers();
  try {
    const { sight, now, asked } = service();
    sight.look("eyes");
    await vi.advanceTimersByTimeAsync(14_000);
    expect(now()).toMatchObject({ isLooking: true, problem: undefined });
    await vi.advanceTimersByTimeAsync(2000);
    expect(now()).toMatchObject({ isLooking: false, seen: undefined, problem: "the camera does not answer" });
    sight.look("eyes");
    expect(asked()).toHaveLength(4);
  } finally {
    vi.useRealTimers();
  }
});
