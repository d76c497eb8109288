// A few workers for many pieces of work: each does one at a time; another is made while all are busy and there may be more.

/** Answers what hands a piece of work to a free worker, and gives its result. If no worker can be made, it says why. */
export function createPool<Worker>(make: () => Promise<Worker>, most: number): <T>(work: (worker: Worker) => Promise<T>) => Promise<T> {
  const free: Worker[] = [];
  const waiting: (() => void)[] = [];
  let made = 0;
  const wake = () => waiting.shift()?.();
  const take = async (): Promise<Worker> => {
    for (;;) {
      const idle = free.pop();
      if (idle !== undefined) return idle;
      if (made < most) break;
      await new Promise<void>((resolve) => waiting.push(resolve));
    }
    made++;
    try {
      return await make();
    } catch (error) {
      made--;
      wake();
      throw error;
    }
  };
  return async (work) => {
    const worker = await take();
    try {
      return await work(worker);
    } finally {
      free.push(worker);
      wake();
    }
  };
}
