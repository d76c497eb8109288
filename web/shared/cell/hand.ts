// A hand of this page: grabs, drags to the newest target about 30 times a second, releases. One request at a time, so
// that they arrive in order; each keeps the hand alive on the server.
import type { PersonCommand, Vector } from "../../generated/messages";

export interface HandOptions {
  /** Its name at the cell, unique to this page. */
  readonly name: string;
  readonly send: (command: PersonCommand) => Promise<unknown>;
  readonly wait: (milliseconds: number) => Promise<void>;
  /** The server refused a command; the hand holds nothing. */
  readonly onRefused: (error: unknown) => void;
}

const kPeriod = 33; // ms

export interface Hand {
  /** Grabs a point [m, in the body's frame] and releases what it held before. */
  readonly grab: (body: string, point: Vector) => Promise<void>;
  /** Sets the target of that point [m, in o]. */
  readonly drag: (to: Vector) => void;
  readonly release: () => void;
}

export function createHand({ name, send, wait, onRefused }: HandOptions): Hand {
  let grip = 0; // counts; 0 and those that are over hold nothing
  let held = 0;
  let target: Vector | undefined;
  const newest = (): Vector | undefined => target;
  let last: Promise<unknown> = Promise.resolve();
  const inTurn = <T>(work: () => Promise<T>): Promise<T> => {
    const next = last.then(work);
    last = next.catch(() => undefined);
    return next;
  };
  return {
    async grab(body, point) {
      const mine = ++grip;
      held = mine;
      target = undefined;
      try {
        const take = () => send({ act: "grab", hand: name, body, point });
        const draw = (to: Vector) => send({ act: "drag", hand: name, to });
        await inTurn(take);
        while (held === mine) {
          const to = newest();
          // The server releases the hand of a page that was too slow: grab again, once.
          if (to !== undefined) await inTurn(() => draw(to).catch(() => take().then(() => draw(to))));
          await wait(kPeriod);
        }
      } catch (error) {
        if (held === mine) held = 0;
        onRefused(error);
      }
    },
    drag(to) {
      target = to;
    },
    release() {
      if (held === 0) return;
      held = 0;
      inTurn(() => send({ act: "release", hand: name })).catch(onRefused);
    },
  };
}
