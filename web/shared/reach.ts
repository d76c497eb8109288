// Whether the server answers: where a network is gone, no socket says so for minutes.

/** Between two questions [ms]. */
export const kAsk = 1000;
/** Without an answer for so long [ms], the server is out of reach. */
export const kPatience = 1500;
/** One question may be lost by itself. */
export const kFailures = 2;

export interface ReachOptions {
  readonly fetcher: typeof fetch;
  /** Calls `act` each so many ms; the result ends that. */
  readonly every: (time: number, act: () => void) => () => void;
  /** A signal that aborts after so many ms. */
  readonly timeout: (time: number) => AbortSignal;
  /** Whether somebody can see the page: only then it asks. */
  readonly isSeen: () => boolean;
  readonly onLost: () => void;
}

/** Asks from now on; the result ends that. One question at a time; `onLost` is told of the second in a row that is not answered in time, and of each that follows. */
export function watchReach({ fetcher, every, timeout, isSeen, onLost }: ReachOptions): () => void {
  let asks = false;
  let failed = 0;
  /** Of a page that was not seen meanwhile, the device may have slept: that says nothing. */
  const count = (isLost: boolean): void => {
    failed = isLost && isSeen() ? failed + 1 : 0;
    if (failed >= kFailures) onLost();
  };
  async function ask(): Promise<void> {
    if (asks || !isSeen()) return;
    asks = true;
    try {
      await fetcher("/api/v1/health", { cache: "no-store", signal: timeout(kPatience) });
      count(false);
    } catch {
      // Refused at once, or silence: the same.
      count(true);
    } finally {
      asks = false;
    }
  }
  return every(kAsk, () => void ask());
}
