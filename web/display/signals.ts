// What a person hears and feels: the sounds that tasks play, and the alarm of this page.
import { schedule } from "../shared/display/sounds";
import type { Sound } from "../generated/messages";
import { createPlayer } from "./player";

const player = createPlayer();
/** The last sound that the server wanted. */
let playing: number | undefined;

export const unlockSound = (): Promise<void> => player.unlock();

/** Plays each sound once. A sound that the server removes is stopped; one before the first touch is not played. */
export function playSound(sound: Sound | undefined, isAllowed: boolean, played: (id: number) => void): void {
  if (sound?.id === playing) return;
  playing = sound?.id;
  player.silence();
  if (sound === undefined || !isAllowed) return;
  player.play(schedule(sound), sound.volume, () => played(sound.id));
}

/** How a phone shakes [ms on, off, on ..], once it was touched; a browser that cannot is silent. */
export const kBuzz = { press: [20], refused: [60, 60, 60], question: [200, 100, 200], lost: [400, 150, 400, 150, 400] } as const;

export function buzz(kind: keyof typeof kBuzz): void {
  if ("vibrate" in navigator && navigator.userActivation.hasBeenActive) navigator.vibrate([...kBuzz[kind]]);
}

/** That something is wrong which a person must not overlook. */
export function alarm(isAllowed: boolean): void {
  buzz("lost");
  if (isAllowed) player.play(schedule({ id: 0, name: "collision", volume: 1, repeat: 2 }), 1, () => undefined);
}
