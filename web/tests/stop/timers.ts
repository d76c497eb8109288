// Time that a test moves on.

interface Timer {
  readonly at: number;
  readonly act: () => void;
}

export function fakeTime() {
  let time = 0;
  let timers: readonly Timer[] = [];
  /** Lets what was promised happen. */
  const settle = async () => {
    for (let i = 0; i < 20; ++i) await Promise.resolve();
  };
  return {
    now: () => time,
    after: (wait: number, act: () => void): void => void (timers = [...timers, { at: time + wait, act }]),
    settle,
    /** All timers that are due meanwhile, in order. */
    async pass(wait: number): Promise<void> {
      const end = time + wait;
      for (;;) {
        await settle();
        const next = [...timers].sort((a, b) => a.at - b.at)[0];
        if (next === undefined || next.at > end) break;
        timers = timers.filter((timer) => timer !== next);
        time = Math.max(time, next.at);
        next.act();
      }
      time = end;
      await settle();
    },
    /** The device sleeps: its clock goes on, its timers do not. */
    sleep: (wait: number): void => void (time += wait),
  };
}
