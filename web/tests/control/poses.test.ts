// The taught poses are read once for all who ask meanwhile, and what was read before a change does not replace what is read after it.
import { expect, test } from "vitest";
import type { JsonValue } from "../../shared/json";
import { createPoses } from "../../control/poses";

/** A database whose answers to `list` come when they are let go. */
function database() {
  const keys = new Set(["pose_home"]);
  const waiting: (() => void)[] = [];
  const asked: string[] = [];
  const poses = createPoses({
    services: () => [],
    api: {
      callService: (_: string, operation: string, { key }: Readonly<Record<string, JsonValue>> = {}) => {
        asked.push(operation);
        if (operation === "remove" && typeof key === "string") keys.delete(key);
        const answer: JsonValue = operation === "list" ? [...keys] : operation === "get" ? { q: [0, 0, 0, 0, 0, 0, 0] } : null;
        return operation === "list" ? new Promise((resolve) => waiting.push(() => resolve(answer))) : Promise.resolve(answer);
      },
    },
  });
  const settle = () => new Promise((resolve) => setTimeout(resolve));
  return { poses, asked, waiting, settle, lists: () => asked.filter((each) => each === "list").length };
}

test("many ask at once, and the database once", async () => {
  const { poses, waiting, settle, lists } = database();
  for (let i = 0; i < 5; i++) poses.load();
  expect(lists()).toBe(1);
  waiting.forEach((go) => go());
  await settle();
  expect(poses.store.get()).toMatchObject({ names: ["home"], isLoaded: true });
  poses.load();
  expect(lists()).toBe(2);
});

test("an answer that is older than a change is not taken", async () => {
  const { poses, waiting, settle } = database();
  poses.load();
  const removed = poses.remove("home");
  await settle();
  const [old, fresh] = waiting;
  fresh?.();
  await removed;
  old?.();
  await settle();
  expect(poses.store.get().names).toEqual([]);
});
