// A worker pool: each worker does one job at a time; while all are busy, another is created up to a limit.

/** Returns a function that runs a job on a free worker and gives its result. It rejects if no worker can be created. */
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
