import { describe, expect, it } from "vitest";
import * as schema from "../../generated/validators";
import { lengthOf, schedule, soundTable } from "../../shared/display/sounds";
import { check } from "../../shared/messages/check";
import { readJson } from "../files";

const sounds = soundTable(check(schema.sounds, readJson(new URL("../../../api/sounds.json", import.meta.url))));
const sound = (name: string, repeat = 1) => schedule({ id: 1, name, volume: 1, repeat });

describe("api/sounds.json", () => {
  it("holds sounds that end", () => {
    expect(sounds.size).toBeGreaterThan(3);
    for (const notes of sounds.values()) expect(lengthOf(notes)).toBeGreaterThan(0);
  });
});

describe("schedule", () => {
  it("repeats all notes, one turn after the other", () => {
    const once = sound("success");
    const twice = sound("success", 2);
    expect(twice.length).toBe(2 * once.length);
    expect(lengthOf(twice)).toBeCloseTo(2 * lengthOf(once));
    expect(twice[once.length]?.at).toBeCloseTo(lengthOf(once));
  });
  it("is empty for an unknown sound", () => {
    expect(sound("trumpet")).toEqual([]);
    expect(lengthOf([])).toBe(0);
  });
});
