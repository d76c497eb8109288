// The sounds of api/sounds.json: notes in time for the synthesiser. The server uses the same file.
import list from "../../../api/sounds.json";
import type { Note, Sound, Sounds } from "../../generated/messages";
import * as schema from "../../generated/validators";
import { check } from "../messages/check";

type SoundTable = ReadonlyMap<string, readonly Note[]>;

export const soundTable = ({ sounds }: Sounds): SoundTable => new Map(sounds.map(({ name, notes }) => [name, notes]));

const sounds = soundTable(check(schema.sounds, list));

/** From the start to the end of the last note [s]. */
export const lengthOf = (notes: readonly Note[]): number => Math.max(0, ...notes.map((each) => each.at + each.for));

/** All notes of a sound with its repetitions; none if the sound is unknown to this page. */
export function schedule(sound: Sound): readonly Note[] {
  const notes = sounds.get(sound.name) ?? [];
  const length = lengthOf(notes);
  return Array.from({ length: sound.repeat }, (_, turn) => notes.map((each) => ({ ...each, at: each.at + turn * length }))).flat();
}
