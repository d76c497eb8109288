// A long press of a finger: it stays where it is for a while, alone. One that moves is a drag, two are a zoom.

/** How long a finger stays, as on phones [ms]. */
const kLong = 500;
/** A finger is never quite still [px]. */
const kStill = 10;

export interface Finger {
  /** Of the pointer. */
  readonly id: number;
  /** [px] */
  readonly x: number;
  readonly y: number;
}

export interface LongPressOptions {
  /** Does something later [ms]; what it answers prevents that. */
  readonly after: (milliseconds: number, act: () => void) => () => void;
  /** A finger has been here long enough. */
  readonly onPress: (x: number, y: number) => void;
}

export interface LongPress {
  readonly down: (finger: Finger) => void;
  readonly move: (finger: Finger) => void;
  readonly up: (id: number) => void;
}

export function createLongPress({ after, onPress }: LongPressOptions): LongPress {
  const down = new Set<number>();
  let waiting: { readonly finger: Finger; readonly prevent: () => void } | undefined;
  const forget = () => {
    waiting?.prevent();
    waiting = undefined;
  };
  return {
    down(finger) {
      down.add(finger.id);
      forget();
      if (down.size > 1) return;
      const prevent = after(kLong, () => {
        waiting = undefined;
        onPress(finger.x, finger.y);
      });
      waiting = { finger, prevent };
    },
    move({ id, x, y }) {
      if (waiting?.finger.id === id && Math.hypot(x - waiting.finger.x, y - waiting.finger.y) > kStill) forget();
    },
    up(id) {
      down.delete(id);
      forget();
    },
  };
}
