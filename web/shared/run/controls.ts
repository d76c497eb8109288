// Which commands a core takes now, and how far a step goes.
import type { Core, StepRequest } from "../../generated/messages";
import type { State } from "../model/model";

export type Command = "start" | "pause" | "resume" | "again" | "micro" | "macro" | "until" | "stop";

export function isOver(core: Pick<Core, "status">): boolean {
  return core.status === "ended" || core.status === "faulted" || core.status === "aborted";
}

/** What services and robots do upon a command. */
export const kEffects = {
  pause: "the task takes no more inputs; a motion that was called goes on to its end, and the time-outs of open calls run on",
  step: "the task stops again after it; meanwhile, calls that are open go on, and their time-outs run",
  stop: "the run ends, and its services are told to be safe: a robot brakes and stands",
} as const;

/** The commands that this core accepts; none without a core. */
export function allowed(core: Core | undefined): ReadonlySet<Command> {
  if (core === undefined) return new Set();
  if (isOver(core)) return new Set<Command>(["again"]);
  if (core.status === "ready") return new Set<Command>(["start", "micro", "macro", "until"]);
  if (core.status === "running" && !core.paused) return new Set<Command>(["pause", "stop"]);
  const commands = new Set<Command>(["resume", "micro", "macro", "until", "stop"]);
  return core.stepping ? commands.add("pause") : commands;
}

/** The command of the first button, which its key presses too. */
export function primary(core: Core | undefined): Command | undefined {
  const commands = allowed(core);
  return (["start", "resume", "again"] as const).find((command) => commands.has(command));
}

/** Whether the command lets the task begin or go on by itself; a step of a run that has begun does not. */
export const setsGoing = (command: Command, { status }: Pick<Core, "status">): boolean =>
  command === "start" || command === "resume" || command === "again" || (status === "ready" && (command === "micro" || command === "macro" || command === "until"));

export type UntilRequest = Extract<StepRequest, { readonly kind: "until" }>;

/** Goes on until the state at `path` is entered or left. It is named by its id, if it has one: an edit may move it meanwhile. */
export function until({ id }: State, path: string, when: UntilRequest["when"]): UntilRequest {
  return id === undefined ? { kind: "until", path, when } : { kind: "until", id, when };
}

/** A port of the root of such a name tells that the task was not done. */
const kBadPort = /^(error|fail|abort|cancel|lost|timeout|time_out)/i;

export const isBadOutcome = (outcome: string | undefined): boolean => outcome !== undefined && kBadPort.test(outcome);

/** The status of a core as far as colours tell it: a run that is paused waits, one that ended badly has failed. */
export function statusLook({ status, paused, outcome }: Pick<Core, "status" | "paused"> & { readonly outcome?: string | undefined }): Core["status"] | "paused" | "failed" {
  if (status === "running" && paused) return "paused";
  return status === "ended" && isBadOutcome(outcome) ? "failed" : status;
}

/** What goes on while the task of a core is paused; nothing if it is not, or has not begun. */
export const goesOnMeanwhile = (core: Pick<Core, "status" | "paused">): string | undefined => (isHeld(core) ? `Paused: ${kEffects.pause}` : undefined);

/** Whether a run that has begun is paused. */
export const isHeld = ({ status, paused }: Pick<Core, "status" | "paused">): boolean => status === "running" && paused;

/** Whether a run is held while something has come for it. */
export const holdsInputs = (core: Pick<Core, "status" | "paused" | "waiting" | "step">): boolean => isHeld(core) && core.waiting > 0 && core.step > 0;

/** The status of a core in one line. */
export function statusText(core: Core): string {
  switch (core.status) {
    case "ready":
      return core.paused ? "Ready, paused before its start" : "Ready";
    case "running":
      if (!core.paused) return "Running";
      return core.stepping ? "Paused, its step waits for an input" : "Paused";
    case "interrupted":
      return "Interrupted";
    case "ended":
      return core.outcome === undefined ? "Ended" : `Ended: ${core.outcome}`;
    case "faulted":
      return `Faulted: ${core.fault?.kind ?? "unknown"}`;
    case "aborted":
      return "Stopped";
  }
}
