// One start by one press: a double click, a double tap or a held key is one press.

/** Clicks that follow within this time are of the same press [ms]. */
export const kSamePress = 500;

export interface OnlyOnceOptions {
  /** For so long after a press [ms], what follows is of the same press, although it is answered. */
  readonly settle: number;
  /** Calls `act` after so many ms. */
  readonly after: (time: number, act: () => void) => void;
  /** Whether something is on its way, or its press may not be over. */
  readonly onChange: (isBusy: boolean) => void;
}

/** The result does something unless it is doing something already: then it does nothing. Rejects as `act` does. */
export function onlyOnce({ settle, after, onChange }: OnlyOnceOptions): (act: () => Promise<unknown>) => Promise<void> {
  let isBusy = false;
  const change = (next: boolean): void => {
    isBusy = next;
    onChange(next);
  };
  return async (act) => {
    if (isBusy) return;
    change(true);
    const settled = new Promise<void>((resolve) => (settle === 0 ? resolve() : after(settle, resolve)));
    try {
      await act();
    } finally {
      void settled.then(() => change(false));
    }
  };
}
