// Edits of the document of a run, in words: what is not yet in the run, and what it waits for.
import type { Core } from "../../generated/messages";
import { countErrors, errorsText } from "./errorsText";
import { isInterrupted } from "./interruption";

export interface EditText {
  readonly title: string;
  /** The nodes or parameters that hold it up, or what is wrong with it; the path is a node's or a port's. */
  readonly waits: readonly { readonly path: string; readonly text: string }[];
  readonly holds: string;
}

type Obstacle = NonNullable<Core["waiting_edit"]>["waits"][number];

const obstacleText = ({ path, parameter }: Obstacle): string =>
  parameter === undefined ? `${path} is active, and the edit removes it` : `${path} would have no value for its parameter ${parameter}`;

/** What the page says of an edit that the core has not got; nothing if there is none. */
export function editText(core: Core): EditText | undefined {
  const { waiting_edit: waiting, refused_edit: refused } = core;
  if (refused !== undefined)
    return {
      title: `Revision ${refused.revision} of ${core.document} has ${errorsText(countErrors(refused.errors, refused.more_errors))} and cannot be executed`,
      waits: refused.errors.map(({ path, message }) => ({ path, text: path === "" ? message : `${path}: ${message}` })),
      holds: `The run goes on with revision ${core.revision}.`,
    };
  if (waiting === undefined) return undefined;
  return {
    title: `Revision ${waiting.revision} of ${core.document} is not in this run yet`,
    waits: waiting.waits.map((obstacle) => ({ path: obstacle.path, text: obstacleText(obstacle) })),
    holds: waiting.waits.length > 0 ? `Until this changes, the run goes on with revision ${core.revision}.` : whenItGoesOn(core),
  };
}

const whenItGoesOn = (core: Core): string =>
  core.paused || isInterrupted(core) ? "It is delivered when the run goes on." : "It is delivered at the end of this macro step.";

/** Changes when the native model of the core does. */
export const modelKey = (core: Core): string => `${core.revision}/${core.model}`;
