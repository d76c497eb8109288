// What the page that edits says of the run of its document.
import type { Core } from "../../generated/messages";
import type { JsonValue } from "../json";
import { valueText } from "../model/describe";
import { isOver } from "../run/controls";
import { isSame } from "../edit/difference/same";
import { counted } from "../counted";

const executes = (core: Core): string => (core.status === "ready" ? "will execute" : isOver(core) ? "is over; it executed" : "executes");

export const changesText = (count: number): string => counted(count, "change");

/** What runs and what is edited: `revision` is the document's last one that is here. The number of changes follows. */
export function executesText(core: Core, revision: number): string {
  const run = `Run ${core.id} ${executes(core)} revision ${core.revision}`;
  return core.revision === revision ? `${run}, which you edit` : `${run}; you edit revision ${revision}`;
}

/** Of revisions that differ, but in nothing that has a row. */
export const kNothingElse = "nothing but the drawing, notes, comments or the way numbers are written differs";

export interface ParameterNow {
  /** What the run has of it; nothing: no value. */
  readonly now: JsonValue | undefined;
  /** The constant that is edited; nothing: it has none, but an expression or no value. */
  readonly constant: JsonValue | undefined;
  /** Of the root: its value comes with the run. */
  readonly isArgument: boolean;
  /** The run executes the constant that is edited. */
  readonly isExecuted: boolean;
  readonly isActive: boolean;
  readonly core: Pick<Core, "live">;
}

/** What stands beside a parameter in its form; nothing: the run has no value, and nothing is on its way. */
export function parameterText({ now, constant, isArgument, isExecuted, isActive, core }: ParameterNow): string | undefined {
  if (now === undefined) return undefined;
  const value = `${isActive || isArgument ? "now" : "last"}: ${valueText(now)}`;
  if (constant === undefined || isSame(constant, now)) return value;
  if (isArgument) return `used by the next run; ${value}`;
  if (isExecuted) return `used from the next activation on; ${value}`;
  return `${core.live ? "not in the run yet" : "not in the run, which does not follow edits"}; ${value}`;
}
