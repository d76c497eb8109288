// When what a person does is sent: soon, but not too often; the last of it counts. And once in a while even if nothing changes.

/** From one message to the next, at least [ms]: 25 in a second. */
export const kPeriod = 40;
/** From one message to the next, at most; the server takes who says nothing for 30 s as gone [ms]. */
export const kHeartbeat = 10_000;

export interface Pace {
  /** What is to be sent has changed. */
  readonly changed: () => void;
  /** It is sent now, whatever was sent before: the connection is new, or the page is seen again. */
  readonly renew: () => void;
  readonly close: () => void;
}

/** `send` gets what is to be sent then; `isAwake`: whether the person is there. */
export function openPace<T>(current: () => T, send: (what: T) => void, isAwake: () => boolean): Pace {
  let last = -Infinity;
  let sent: string | undefined;
  let waiting: ReturnType<typeof setTimeout> | undefined;
  const sendNow = (always: boolean) => {
    waiting = undefined;
    const what = current();
    const text = JSON.stringify(what);
    if (text === sent && !always) return;
    sent = text;
    last = performance.now();
    send(what);
  };
  const changed = () => {
    if (waiting !== undefined) return;
    const wait = last + kPeriod - performance.now();
    if (wait <= 0) sendNow(false);
    else waiting = setTimeout(() => sendNow(false), wait);
  };
  const renew = () => {
    clearTimeout(waiting);
    sendNow(true);
  };
  const beat = setInterval(() => isAwake() && renew(), kHeartbeat);
  return {
    changed,
    renew,
    close: () => {
      clearTimeout(waiting);
      clearInterval(beat);
    },
  };
}
