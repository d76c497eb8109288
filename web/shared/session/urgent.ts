// Which changes of a page's session are shown at once: all but those that a run makes while it goes on by itself.
import type { Core, HostedService } from "../../generated/messages";
import { isAsking } from "../run/displayCalls";
import { watchedCore, type Session } from "./session";

/** What each step of a run, its calls and the log of the server change. */
const kOften: ReadonlySet<string> = new Set<keyof Session>(["cores", "run", "fired", "lastInput", "onDisplays", "questions", "forced", "snapshots", "steps", "services", "log"]);
const kCounters: ReadonlySet<string> = new Set<keyof Core>(["step", "micro", "waiting"]);

const differing = <T extends object>(before: T, now: T): readonly string[] =>
  (Object.keys({ ...before, ...now }) as (keyof T & string)[]).filter((key) => before[key] !== now[key]);

/** What is no number, text or truth comes anew with each message: of a list the length is compared, else only whether it is there. */
const gist = (value: unknown): unknown => (Array.isArray(value) ? `${value.length}` : typeof value === "object" ? value !== null : value);

/** Whether cores came, went, or are otherwise than further on. */
function coresTurned(before: readonly Core[], now: readonly Core[]): boolean {
  if (before === now) return false;
  if (before.length !== now.length) return true;
  return now.some((core, i) => {
    const known = before[i];
    return known === undefined || (known !== core && differing(known, core).some((key) => !kCounters.has(key) && gist(Reflect.get(known, key)) !== gist(Reflect.get(core, key))));
  });
}

/** The calls that people are to answer, as text. */
const questions = (services: readonly HostedService[]): string =>
  services.flatMap(({ key, type, pending }) => (type === "display" ? pending.filter(({ operation }) => isAsking(operation)).map(({ call }) => `${key} ${call}`) : [])).join();

/** Whether services came, went or ask otherwise. */
const servicesTurned = (before: readonly HostedService[], now: readonly HostedService[]): boolean =>
  before !== now && (before.length !== now.length || now.some(({ available }, i) => available !== before[i]?.available) || questions(before) !== questions(now));

/** Whether `now` has something that people wait for: a run began, paused, faulted, asks or ended, a paused one made a step, the page turned to another
 *  run or moment, the server was lost. */
export function isUrgent(before: Session, now: Session): boolean {
  if (differing(before, now).some((key) => !kOften.has(key))) return true;
  const core = watchedCore(now);
  const goesOn = core?.status === "running" && !core.paused;
  const isMoved = before.run !== now.run || before.steps !== now.steps || watchedCore(before) !== core;
  return (isMoved && !goesOn) || coresTurned(before.cores, now.cores) || servicesTurned(before.services, now.services);
}
