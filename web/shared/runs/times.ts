// What is known of the times of a run: when its macro steps began, how long calls took, which states services had.
import type { Timing } from "../../generated/messages";
import type { CallSpan, LineStep } from "./timeline";

/** All in microseconds since the run was made. */
export interface Times {
  readonly began: ReadonlyMap<number, number>;
  /** When the event or response came that a macro step delivered. */
  readonly arrived: ReadonlyMap<number, number>;
  readonly services: readonly ServiceSpans[];
  readonly until: number;
}

export interface ServiceSpans {
  readonly service: string;
  /** The states that it had, one after the other; none where it was not available. */
  readonly spans: readonly { readonly state: string | undefined; readonly from: number; readonly to: number }[];
}

const kSecond = 1e6;

function serviceSpans({ services, until }: Timing): readonly ServiceSpans[] {
  const keys = [...new Set(services.map(({ service }) => service))];
  return keys.map((service) => {
    const changes = services.filter((change) => change.service === service);
    return { service, spans: changes.map(({ state, time }, i) => ({ state, from: time, to: changes[i + 1]?.time ?? Math.max(time, until) })) };
  });
}

export function timesOf(timing: Timing): Times {
  return {
    began: new Map(timing.steps.map(({ step, time }) => [step, time])),
    arrived: new Map(timing.steps.flatMap(({ step, arrived }) => (arrived === undefined ? [] : [[step, arrived] as const]))),
    services: serviceSpans(timing),
    until: Math.max(timing.until, timing.steps.at(-1)?.time ?? 0),
  };
}

/** How long a call took until its answer was there [s]; nothing: it is not known, or has none. */
export function durationOf({ from, to }: CallSpan, times: Times | undefined): number | undefined {
  const [called, answered] = [times?.began.get(from), to === undefined ? undefined : times?.arrived.get(to)];
  return called === undefined || answered === undefined ? undefined : Math.max(0, answered - called) / kSecond;
}

/** A time in seconds with as many digits as can be meant: `0.301 s`, `12.4 s`, `350 s`. */
export function secondsText(seconds: number): string {
  const digits = seconds < 1 ? 3 : seconds < 10 ? 2 : seconds < 100 ? 1 : 0;
  return `${seconds.toFixed(digits)} s`;
}

/** The services that the macro steps call or hear, or whose state changed meanwhile. */
export function servicesShown({ services }: Times, steps: readonly LineStep[]): readonly ServiceSpans[] {
  const named = new Set(steps.flatMap(({ input, called }) => [...called, ...("service" in input ? [input.service] : [])]));
  return services.filter(({ service, spans }) => (named.has(service) && spans.some(({ state }) => state !== undefined)) || spans.length > 1);
}

/** When macro step `step` began [s], by the clock that begins with the first macro step of the run, or with the first one that is known. */
export const secondsAt = (times: Times, step: number): number | undefined => {
  const [time, origin] = [times.began.get(step), originOf(times)];
  return time === undefined || origin === undefined ? undefined : (time - origin) / kSecond;
};

const originOf = ({ began }: Times): number | undefined => began.get(1) ?? began.values().next().value;
