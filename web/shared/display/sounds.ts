// The sounds of api/sounds.json: notes in time, as a synthesiser wants them. The server knows the same file.
import list from "../../../api/sounds.json";
import { array, number, object, oneOf, string, type Decoder } from "../json/decode";
import type { Sound } from "../messages/display";

export interface Note {
  /** Start [s]. */
  readonly at: number;
  /** Duration [s]. */
  readonly for: number;
  /** [Hz] */
  readonly frequency: number;
  readonly wave: "sine" | "square" | "sawtooth" | "triangle";
}

const note: Decoder<Note> = object((f) => ({
  at: f.need("at", number),
  for: f.need("for", number),
  frequency: f.need("frequency", number),
  wave: f.need("wave", oneOf("sine", "square", "sawtooth", "triangle")),
}));

export const soundList: Decoder<ReadonlyMap<string, readonly Note[]>> = object(
  (f) =>
    new Map(
      f.need("sounds", array(object((s): readonly [string, readonly Note[]] => [s.need("name", string), s.need("notes", array(note))]))),
    ),
);

const sounds = soundList(list, "");

/** From the start to the end of the last note [s]. */
export const lengthOf = (notes: readonly Note[]): number => Math.max(0, ...notes.map((each) => each.at + each.for));

/** All notes of a sound with its repetitions; none if the sound is unknown to this page. */
export function schedule(sound: Sound): readonly Note[] {
  const notes = sounds.get(sound.name) ?? [];
  const length = lengthOf(notes);
  return Array.from({ length: sound.repeat }, (_, turn) => notes.map((each) => ({ ...each, at: each.at + turn * length }))).flat();
}
