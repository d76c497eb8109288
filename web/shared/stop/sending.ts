// One press of STOP: sent to all addresses at once, again every half second, until one of them answers or it is given up.

/** Between two attempts [ms]. */
export const kRetry = 500;
/** After this it is given up [ms]: a stop must not come when nobody expects it any more. */
export const kPatience = 5000;

export interface SendingOptions {
  /** Asked for each attempt: more may be known by then. */
  readonly addresses: () => readonly string[];
  /** Resolves if the stop was answered. */
  readonly post: (address: string, signal: AbortSignal) => Promise<void>;
  /** Calls `act` once, after so many ms; later, if the device slept. */
  readonly after: (time: number, act: () => void) => void;
  /** [ms] */
  readonly now: () => number;
  /** The first attempt was not answered at once. */
  readonly onLate: () => void;
}

export interface Sending {
  /** Whether the stop was answered in time. */
  readonly answered: Promise<boolean>;
  /** Takes back what no server has got yet. */
  readonly end: () => void;
}

export function sendStop({ addresses, post, after, now, onLate }: SendingOptions): Sending {
  const begun = now();
  const sent = new AbortController();
  let isAnswered = false;
  let settle: (answered: boolean) => void = () => undefined;
  const answered = new Promise<boolean>((resolve) => (settle = resolve));
  const end = () => {
    sent.abort();
    settle(false);
  };
  const attempt = () => {
    for (const address of addresses())
      post(address, sent.signal).then(() => {
        if (sent.signal.aborted) return;
        isAnswered = true;
        settle(true);
      }, () => undefined);
  };
  attempt();
  for (let time = kRetry; time < kPatience; time += kRetry)
    after(time, () => {
      if (isAnswered || sent.signal.aborted) return;
      // A device that slept does not stop the cell when it wakes up.
      if (now() - begun >= kPatience) {
        end();
        return;
      }
      onLate();
      attempt();
    });
  // Also after an answer: the other address may still be on its way.
  after(kPatience, end);
  return { answered, end };
}
