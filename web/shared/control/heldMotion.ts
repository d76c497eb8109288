// A motion that goes on while a person holds a button: called at once, most of them anew in short intervals, and ended at once.
import type { JsonValue } from "../json";
import { messageOf } from "../messageOf";
import { standing, type Jog } from "./jog";

/** Between two calls [ms]: the robot stops by itself 0.25 s after the last one. */
export const kRepeat = 80;
/** More unanswered calls mean that the server is late: then it gets no further ones. */
export const kMostUnanswered = 3;
/** So many times in a row it did not get one: it does not answer, which ends the motion. */
export const kMostLate = 12;

type Arguments = Readonly<Record<string, JsonValue>>;

/** What is called while a button is held. */
export interface HeldCall {
  readonly operation: string;
  readonly kwargs: Arguments;
  /** The robot does it only while it is called anew; otherwise it is called once, and goes on to its end. */
  readonly repeats: boolean;
  /** The arguments with which the same operation stands. */
  readonly standing?: Arguments;
}

export const jogging = (jog: Jog): HeldCall => ({ operation: "jog", kwargs: { ...jog }, repeats: true, standing: { ...standing(jog) } });
/** The arm gives way to a hand. */
export const kGuiding: HeldCall = { operation: "guide", kwargs: {}, repeats: true };
/** Straight in joint space, to joints [rad]; `speed`: share of the fastest. */
export const goingTo = (joints: readonly number[], speed: number): HeldCall => ({ operation: "move", kwargs: { target: { joints }, speed, acceleration: speed }, repeats: false });

export interface HeldMotionOptions {
  readonly call: (operation: string, kwargs: Arguments) => Promise<unknown>;
  /** Calls `act` each so many ms; the result ends that. */
  readonly every: (time: number, act: () => void) => () => void;
  /** The robot does not do it, or no more. */
  readonly onRefused: (why: string) => void;
  /** What is called once has come to its end, while the button was held. */
  readonly onDone?: () => void;
}

export function createHeldMotion({ call, every, onRefused, onDone }: HeldMotionOptions) {
  let held: HeldCall | undefined;
  let endRepeats: (() => void) | undefined;
  let unanswered = 0;
  let late = 0;

  function end(): void {
    if (held === undefined) return;
    endRepeats?.();
    endRepeats = undefined;
    const { operation, standing: stands } = held;
    held = undefined;
    // Either is enough; what does not come through matters to nobody, as the robot stops without.
    if (stands !== undefined) call(operation, stands).catch(() => undefined);
    call("stop", {}).catch(() => undefined);
  }

  function give(why: string): void {
    end();
    onRefused(why);
  }

  function again(): void {
    const called = held;
    if (called === undefined) return;
    if (unanswered >= kMostUnanswered) {
      if (!called.repeats || ++late >= kMostLate) give("the server does not answer");
      return;
    }
    late = 0;
    unanswered++;
    call(called.operation, called.kwargs)
      .then(
        () => {
          if (held !== called || called.repeats) return;
          held = undefined;
          onDone?.();
        },
        // That of a motion that was ended meanwhile is no news.
        (error: unknown) => held === called && give(messageOf(error)),
      )
      .finally(() => unanswered--);
  }

  return {
    /** Begins a motion, in place of another one. */
    start(wanted: HeldCall): void {
      end();
      held = wanted;
      late = 0;
      again();
      if (wanted.repeats) endRepeats = every(kRepeat, again);
    },
    /** To be called whenever a button may be held no more. */
    end,
    isMoving: (): boolean => held !== undefined,
  };
}

export type HeldMotion = ReturnType<typeof createHeldMotion>;
