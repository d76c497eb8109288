// The synthesiser: notes as oscillators of WebAudio. One sound at a time.
import type { Note } from "../generated/messages";
import { lengthOf } from "../shared/display/sounds";

export interface Player {
  /** To be called on a touch; resolves when sounds may be played. */
  readonly unlock: () => Promise<void>;
  /** `ended` is called when the last note is over, unless it was silenced before. */
  readonly play: (notes: readonly Note[], volume: number, ended: () => void) => void;
  readonly silence: () => void;
}

/** Rise and fall of a note [s], so that it does not click. */
const kEdge = 0.01;
/** Of the loudest sound: several notes at once must not clip. */
const kLevel = 0.4;

export function createPlayer(): Player {
  let context: AudioContext | undefined;
  let output: GainNode | undefined;
  let timer: ReturnType<typeof setTimeout> | undefined;

  const silence = () => {
    clearTimeout(timer);
    output?.disconnect();
    output = undefined;
  };

  const sound = (audio: AudioContext, note: Note, start: number, into: AudioNode) => {
    const oscillator = new OscillatorNode(audio, { type: note.wave, frequency: note.frequency });
    const envelope = new GainNode(audio, { gain: 0 });
    const from = start + note.at;
    const to = from + note.for;
    envelope.gain.setValueAtTime(0, from);
    envelope.gain.linearRampToValueAtTime(1, from + kEdge);
    envelope.gain.setValueAtTime(1, Math.max(from + kEdge, to - kEdge));
    envelope.gain.linearRampToValueAtTime(0, to);
    oscillator.connect(envelope).connect(into);
    oscillator.start(from);
    oscillator.stop(to);
  };

  return {
    silence,
    async unlock() {
      context ??= new AudioContext();
      if (context.state !== "running") await context.resume();
    },
    play(notes, volume, ended) {
      silence();
      if (context === undefined) return;
      const audio = context;
      const start = audio.currentTime;
      output = new GainNode(audio, { gain: volume * kLevel });
      output.connect(audio.destination);
      for (const note of notes) sound(audio, note, start, output);
      // Uses the audio clock: it stands still while the browser does not let the page play.
      const end = start + lengthOf(notes);
      const check = () => {
        const rest = end - audio.currentTime;
        if (rest > 0) timer = setTimeout(check, Math.max(20, rest * 1000));
        else {
          silence();
          ended();
        }
      };
      check();
    },
  };
}
