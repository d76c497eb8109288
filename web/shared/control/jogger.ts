// A motion that goes on while a person holds a button: called at once and anew in short intervals, and ended at once.
import type { JsonValue } from "../json";
import { messageOf } from "../messageOf";
import { standing, type Jog } from "./jog";

/** Between two calls [ms]: the robot stops by itself 0.25 s after the last one. */
export const kRepeat = 80;
/** More unanswered calls mean that the server is late: then it gets no further ones. */
export const kMostUnanswered = 3;

export interface JoggerOptions {
  readonly call: (operation: "jog" | "stop", kwargs: Readonly<Record<string, JsonValue>>) => Promise<unknown>;
  /** Calls `act` each so many ms; the result ends that. */
  readonly every: (time: number, act: () => void) => () => void;
  /** The robot does not do it. */
  readonly onRefused: (why: string) => void;
}

export function createJogger({ call, every, onRefused }: JoggerOptions) {
  let jog: Jog | undefined;
  let endRepeats: (() => void) | undefined;
  let unanswered = 0;

  function end(): void {
    if (jog === undefined) return;
    endRepeats?.();
    const stands = standing(jog);
    jog = undefined;
    // Either is enough; what does not come through matters to nobody, as the robot stops without.
    for (const [operation, kwargs] of [["jog", stands], ["stop", {}]] as const) call(operation, { ...kwargs }).catch(() => undefined);
  }

  function again(): void {
    const called = jog;
    if (called === undefined || unanswered >= kMostUnanswered) return;
    unanswered++;
    call("jog", { ...called })
      .catch((error: unknown) => {
        // That of a motion that was ended meanwhile is no news.
        if (jog !== called) return;
        end();
        onRefused(messageOf(error));
      })
      .finally(() => unanswered--);
  }

  return {
    /** Begins a motion, in place of another one. */
    start(wanted: Jog): void {
      end();
      jog = wanted;
      again();
      endRepeats = every(kRepeat, again);
    },
    /** To be called whenever a button may be held no more. */
    end,
    isMoving: (): boolean => jog !== undefined,
  };
}

export type Jogger = ReturnType<typeof createJogger>;
