// What a page says of the controls.
import type { CellMode, Control } from "../../generated/messages";
import type { LinkState } from "./link";

/** How fast the tool is at most in programming mode [mm/s]: control.json, `cell_mode`. */
export const kReducedSpeed = 250;

export const modeName = (mode: CellMode): string => (mode === "programming" ? "Programming" : "Execution");

/** `Programming mode, reduced speed 250 mm/s` */
export const modeText = (mode: CellMode): string => `${modeName(mode)} mode${mode === "programming" ? `, reduced speed ${kReducedSpeed} mm/s` : ""}`;

export const kModeMeans: Readonly<Record<CellMode, string>> = {
  execution: "Runs go by themselves, and nothing is moved by hand.",
  programming: `The cell is moved by hand, and runs move only while somebody has the controls; no tool is faster than ${kReducedSpeed} mm/s.`,
};

/** Whether the taking that everybody is told of is that of this page, which may know of it before. */
export const isOwn = (holder: Control["holder"], held: number | undefined): boolean => held !== undefined && (holder === null || holder.number <= held);

/** `You have the controls`; `held`: the taking of this page. */
export function holderText(holder: Control["holder"], held: number | undefined): string {
  if (isOwn(holder, held)) return "You have the controls";
  return holder === null ? "Nobody has the controls" : `${holder.by} has the controls`;
}

export const kLostMeans = "What you moved by hand has stopped, and runs that needed you are paused.";

/** What is to be read at once; nothing: there is nothing. `holder`: who has them now. */
export function linkWarning(state: LinkState, holder: Control["holder"]): { readonly title: string; readonly why: string; readonly means?: string } | undefined {
  const now = holder === null ? "" : `; ${holder.by} has them now`;
  if (state.kind === "lost") return { title: "You have LOST the controls", why: state.why + now, means: kLostMeans };
  if (state.kind === "refused") return { title: "You do not get the controls", why: state.why };
  return undefined;
}

/** How long a person at the cell has to answer [s]: control_request.json. */
export const kAnswerTime = 30;

/** What is left of it, if it began at `since` [ms]. */
export const leftToAnswer = (since: number, now: number): number => Math.max(0, Math.ceil(kAnswerTime - (now - since) / 1000));
