// What a page says of the stop.
import { kStopKey } from "./key";
import type { Stopped, StopView } from "./state";

const kTime: Intl.DateTimeFormatOptions = { hour: "2-digit", minute: "2-digit", second: "2-digit", hourCycle: "h23" };

/** `14:03:05`, with the day if that is another one. */
function clockText(time: number, now: number): string {
  const clock = new Intl.DateTimeFormat("en-GB", kTime).format(time);
  const isToday = new Date(time).toDateString() === new Date(now).toDateString();
  return isToday ? `at ${clock}` : `on ${new Intl.DateTimeFormat("en-GB", { dateStyle: "medium" }).format(time)} at ${clock}`;
}

/** `STOPPED by alice at 14:03:05` */
export function stoppedText({ by, time }: Stopped, now: number): string {
  return ["STOPPED", ...(by === undefined ? [] : [`by ${by}`]), ...(time === undefined ? [] : [clockText(time, now)])].join(" ");
}

export const kStoppedMeans = "All runs have ended. Nothing moves until the reset, and the reset starts nothing.";

export const kStopHint = `STOP (${kStopKey}): the robot brakes, all runs end, and nothing moves until the reset. This is no emergency stop.`;

/** What is to be read at once, and what to do; nothing: there is nothing to warn of. */
export function warningText(view: StopView): { readonly title: string; readonly act: string } | undefined {
  if (view === "late") return { title: "STOP has no answer yet.", act: "If anything moves, use the robot's own emergency stop." };
  if (view === "failed") return { title: "STOP did NOT reach the server.", act: "Use the robot's own emergency stop. This stop is not sent any more: press STOP to try again." };
  return undefined;
}

export const kResetQuestion = "Is nobody in the reach of the robot? The reset moves nothing.";
