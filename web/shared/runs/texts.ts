// Stored runs in words.
import type { Core, Run, Timing } from "../../generated/messages";
import { statusText } from "../run/controls";
import { coreOfRun } from "./storedRun";
import { counted } from "../counted";

/** What the page says over a stored run that it shows at its end. */
export function storedText(core: Core): { readonly title: string; readonly holds: string } {
  const steps = counted(core.step, "macro step");
  return { title: `Run ${core.id} of ${core.document} is stored; no core hosts it.`, holds: `${statusText(core)}, after ${steps}.` };
}

/** What a run came to; of one that no core hosts and that is not over, that it was left. */
export const outcomeText = (run: Run): string => (run.status === "running" && run.imported ? "Not over" : statusText(coreOfRun(run)));

const kUnits = [["d", 86_400], ["h", 3600], ["min", 60]] as const;

/** The time between two moments [ms], in its two largest units. */
export function durationText(ms: number): string {
  const seconds = ms / 1000;
  if (seconds < 60) return seconds < 10 ? `${seconds.toFixed(1)} s` : `${Math.round(seconds)} s`;
  let left = Math.round(seconds);
  const parts = kUnits.flatMap(([unit, size]) => {
    const count = Math.floor(left / size);
    left -= count * size;
    return count === 0 ? [] : [`${count} ${unit}`];
  });
  return [...parts, ...(left === 0 ? [] : [`${left} s`])].slice(0, 2).join(" ");
}

/** How long a run took; nothing if it is not over. */
export const runTime = ({ created, ended }: Run): string | undefined => (ended === undefined ? undefined : durationText(Math.max(0, ended - created)));

/** How long a run was under way, from its first macro step, whose time is among `timing` if it is known, else from when it was made; nothing if it
 *  is not over. */
export function underWay({ created, ended }: Pick<Run, "created" | "ended">, { steps }: Pick<Timing, "steps">): string | undefined {
  const first = steps.find(({ step }) => step === 1)?.time ?? 0;
  return ended === undefined ? undefined : durationText(Math.max(0, ended - created - first / 1000));
}
