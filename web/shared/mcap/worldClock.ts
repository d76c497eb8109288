// The world's clock laid on that of the run. Poses and pictures are recorded with the time of the world and with the macro steps that
// had begun; of the run's own clock it is known when these began. The world goes as fast as that clock, so one offset fits all.
import type { RunTimes } from "./runTimes";

/** Something that was recorded. */
export interface Recorded {
  /** Macro steps that had begun. */
  readonly step: number;
  /** Of the world [s]. */
  readonly time: number;
}

export interface WorldClock {
  /** When it was [us] since the run was made: within the macro step with which it was recorded. */
  readonly at: (recorded: Recorded) => number;
  /** By how much the times may be wrong as a whole [us]; infinite: by anything, as long as the order is right. */
  readonly doubt: number;
}

type Bounds = Pick<RunTimes, "began" | "next">;

const kSecond = 1e6;
const clamp = (value: number, least: number, most: number): number => Math.max(least, Math.min(most, value));

/** A world that came back begins anew: pieces in which its time goes forward. */
function piecesOf(recorded: readonly Recorded[]): readonly (readonly Recorded[])[] {
  const pieces: Recorded[][] = [];
  let before = Infinity;
  for (const one of recorded) {
    if (one.time < before) pieces.push([]);
    pieces.at(-1)?.push(one);
    before = one.time;
  }
  return pieces;
}

/** The offset that contradicts the macro steps least: in the middle of what they allow. */
function offsetOf(piece: readonly Recorded[], { began, next }: Bounds): { readonly offset: number; readonly doubt: number } {
  let [least, most] = [-Infinity, Infinity];
  for (const { step, time } of piece) {
    least = Math.max(least, began(step) - time * kSecond);
    most = Math.min(most, next(step) - time * kSecond);
  }
  return { offset: most === Infinity ? least : (least + most) / 2, doubt: Math.abs(most - least) / 2 };
}

/** `recorded`: in its order, all of one clock. */
export function worldClock(recorded: readonly Recorded[], bounds: Bounds): WorldClock {
  const offsets = piecesOf(recorded).map((piece) => offsetOf(piece, bounds));
  const at = ({ step, time }: Recorded): number => {
    const [from, to] = [bounds.began(step), bounds.next(step)];
    // Of the piece to which it belongs, that is the one by which it is corrected least.
    let best = { correction: Infinity, time: from };
    for (const { offset } of offsets) {
      const wanted = time * kSecond + offset;
      const given = clamp(wanted, from, to);
      const correction = Math.abs(given - wanted);
      if (correction < best.correction) best = { correction, time: given };
    }
    return Math.round(best.time);
  };
  return { at, doubt: Math.max(0, ...offsets.map(({ doubt }) => doubt)) };
}
