// The stop of this page.
import { storedTokens } from "../shared/login/tokens";
import { createStop } from "../shared/stop/stop";

export const stop = createStop({
  place: location,
  fetcher: (input, init) => fetch(input, init),
  token: storedTokens(() => localStorage, window).read,
  after: (time, act) => void setTimeout(act, time),
  now: () => Date.now(),
  nextFrame: (act) => {
    const frame = requestAnimationFrame(act);
    return () => cancelAnimationFrame(frame);
  },
});
