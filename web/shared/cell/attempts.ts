// Attempts to load something until it is here, with pauses that grow: what has failed once is often there a moment later.

/** The first pause, and the longest [ms]. */
const kFirst = 500;
const kLongest = 8000;

/** The pause after so many failures in a row [ms]. */
export const pauseAfter = (failures: number): number => Math.min(kLongest, kFirst * 2 ** (failures - 1));

interface Outcomes<T> {
  readonly onLoaded: (loaded: T) => void;
  /** After each failure; another attempt follows. */
  readonly onFailed: (error: unknown) => void;
}

/** Loads until it succeeds. The result ends that: nothing is told afterwards. */
export function loadInAttempts<T>(load: () => Promise<T>, { onLoaded, onFailed }: Outcomes<T>): () => void {
  let current = true;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let failures = 0;
  const failed = (error: unknown) => {
    if (!current) return;
    timer = setTimeout(attempt, pauseAfter(++failures));
    onFailed(error);
  };
  const attempt = () => void load().then((loaded) => current && onLoaded(loaded), failed);
  attempt();
  return () => {
    current = false;
    clearTimeout(timer);
  };
}
