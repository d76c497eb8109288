// A long press: one finger that stays in place for a while. A finger that moves is a drag, two fingers are a zoom.

/** How long a finger stays, as on phones [ms]. */
const kLong = 500;
/** Movement of a finger that still counts as staying [px]. */
const kStill = 10;

export interface Finger {
  /** Of the pointer. */
  readonly id: number;
  /** [px] */
  readonly x: number;
  readonly y: number;
}

export interface LongPressOptions {
  /** Schedules a callback [ms]; the result cancels it. */
  readonly after: (milliseconds: number, act: () => void) => () => void;
  /** Called at the position of a long press. */
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
