// Whether the server answers: where a network is gone, no socket says so for minutes.

/** Without a word of the server for so long it is asked; also between the beginnings of two questions [ms]. */
export const kAsk = 1000;
/** Without an answer for so long [ms], a question has failed. */
export const kPatience = 1500;
/** One question may be lost by itself. */
export const kFailures = 2;
/** Between two looks at the clock, which tell whether the page itself stood still [ms]. */
export const kLook = 250;
/** A look that is late by more [ms]: the page was busy, and an answer may have waited for it. */
export const kBusy = 500;
/** By more than that [ms]: the device slept, and its network is not back at once. */
export const kAsleep = 5000;

export interface ReachOptions {
  readonly fetcher: typeof fetch;
  /** [ms], also while the device sleeps. */
  readonly now: () => number;
  /** Calls `act` each so many ms; the result ends that. */
  readonly every: (time: number, act: () => void) => () => void;
  /** A signal that aborts after so many ms. */
  readonly timeout: (time: number) => AbortSignal;
  /** Whether somebody can see the page: only then it asks. */
  readonly isSeen: () => boolean;
  /** Whether there is a connection that may be lost. */
  readonly isOpen: () => boolean;
  readonly onLost: () => void;
  /** Of each answer after that, until the connection is open. */
  readonly onBack: () => void;
}

export interface Reach {
  /** The server has sent something: as good as an answer. */
  readonly heard: () => void;
  readonly end: () => void;
}

/** Asks from now on, one question at a time. `onLost` is told of the second in a row that is not answered in time, and of each that follows while a connection is open. */
export function watchReach({ fetcher, now, every, timeout, isSeen, isOpen, onLost, onBack }: ReachOptions): Reach {
  let asks = false;
  let failed = 0;
  let isLost = false;
  let wasBusy = false;
  /** When the last question began, and when the server last said something. */
  let [asked, heard] = [now(), now()];
  let looked = now();

  function look(): void {
    const late = now() - looked - kLook;
    looked = now();
    if (late > kBusy) wasBusy = true;
    if (late > kAsleep) failed = 0;
  }
  function answered(): void {
    failed = 0;
    heard = now();
    if (isLost && isOpen()) isLost = false;
    else if (isLost) onBack();
  }
  /** What happened to a page that was not seen, or stood still, says nothing of the server. */
  function unanswered(): void {
    look();
    if (!isSeen()) failed = 0;
    else if (!wasBusy) failed++;
    if (failed < kFailures || !isOpen()) return;
    isLost = true;
    onLost();
  }
  async function ask(): Promise<void> {
    if (asks || !isSeen() || !(isOpen() || isLost) || now() - Math.max(asked, heard) < kAsk) return;
    asks = true;
    asked = now();
    wasBusy = false;
    try {
      await fetcher("/api/v1/health", { cache: "no-store", signal: timeout(kPatience) });
      answered();
    } catch {
      // Refused at once, or silence: the same.
      if (heard > asked) answered();
      else unanswered();
    } finally {
      asks = false;
    }
  }
  const end = every(kLook, () => {
    look();
    void ask();
  });
  return { heard: () => void (heard = now()), end };
}
