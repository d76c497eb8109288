// What the page says while it looks at the past of a run.
import type { Core, Past } from "../../generated/messages";
import { momentText } from "./moment";
import { counted } from "../counted";

export interface PastText {
  readonly title: string;
  /** Where the run is, or how long it is. */
  readonly holds: string;
}

const presentText = ({ step, micro }: Core): string => (micro > 0 ? momentText({ step, micro }) : String(step));

/** `isStored`: no core hosts the run any more. */
export function pastText(past: Past, core: Core, isStored: boolean): PastText {
  const title = `You look at step ${momentText(past)}.`;
  if (isStored) return { title, holds: `The run has ${counted(core.step, "step")} and is over.` };
  const now = core.status === "ready" || core.status === "running" ? `The run is at ${presentText(core)}` : `The run is over, at ${presentText(core)}`;
  return { title, holds: `${now}. Robots do not move back.` };
}

const kMoves = { running: "Running", ended: "Ended", faulted: "Faulted", aborted: "Stopped" } as const;

/** The status of the run at the moment, in one line. */
export function pastStatus({ status, outcome, fault }: Past): string {
  const detail = outcome ?? fault?.kind;
  return detail === undefined ? kMoves[status] : `${kMoves[status]}: ${detail}`;
}

const microSteps = (count: number): string => counted(count, "micro step");

/** Between which micro steps the moment is. */
export function placeText({ step, micro, complete }: Past): string {
  if (complete) return micro === 0 ? `Nothing changes in macro step ${step}.` : `At the end of macro step ${step}, after ${microSteps(micro)}.`;
  return micro === 0 ? `In macro step ${step}, before its first micro step.` : `In macro step ${step}, after ${microSteps(micro)}.`;
}

/** So many digits tell the moments of a run apart. */
const kShort = 12;
export const shortDigest = (digest: string): string => digest.slice(0, kShort);
