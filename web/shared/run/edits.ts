// Edits of the document of a run, in words: what is not yet in the run, and what it waits for.
import type { Core, ServerError } from "../../generated/messages";
import { nameOf } from "../model/modelTree";
import { countErrors, errorsText } from "./errorsText";
import { isInterrupted } from "./interruption";

export interface EditText {
  readonly title: string;
  /** The nodes or parameters that hold it up, or what is wrong with it; the path is a node's or a port's. */
  readonly waits: readonly { readonly path: string; readonly id?: string; readonly error?: ServerError; readonly text: string }[];
  readonly holds: string;
  /** The revision that somebody has to confirm. */
  readonly confirms?: number;
}

type Obstacle = NonNullable<Core["waiting_edit"]>["waits"][number];

/** So many states are named; of more, their number is told. */
const kMostNamed = 3;

/** What an edit waits for, in one sentence; without obstacles, nothing but time. */
function waitingTitle(what: string, waits: readonly Obstacle[]): string {
  const states = waits.flatMap(({ path, parameter }) => (parameter === undefined ? [nameOf(path)] : []));
  const [first] = waits;
  if (first === undefined) return `${what} is not in this run yet`;
  if (states.length === 0) return `${what} waits for a value of the parameter ${first.parameter ?? ""} of ${nameOf(first.path)}`;
  if (states.length > kMostNamed) return `${what} waits until ${states.length} states are left`;
  return `${what} waits until ${states.join(" and ")} ${states.length === 1 ? "is" : "are"} left`;
}

/** What the page says once the core executes an edit: `before` and `after` are the same core; nothing if its model is the same. */
export function carriedText(before: Core, after: Core): string | undefined {
  if (before.id !== after.id || before.revision === after.revision || before.status === "interrupted") return undefined;
  const since = after.status === "ready" ? "from its beginning" : `since step ${after.model}`;
  return after.status !== "ready" && before.model === after.model ? undefined : `Run ${after.id} executes revision ${after.revision} ${since}`;
}

const obstacleText = ({ path, parameter }: Obstacle): string =>
  parameter === undefined ? `${path} is active, and the edit removes it` : `${path} would have no value for its parameter ${parameter}`;

/** What the page says of an edit that the core has not got; nothing if there is none. */
export function editText(core: Core): EditText | undefined {
  const { waiting_edit: waiting, refused_edit: refused } = core;
  if (refused !== undefined)
    return {
      title: `Revision ${refused.revision} of ${core.document} has ${errorsText(countErrors(refused.errors, refused.more_errors))} and cannot be executed`,
      waits: refused.errors.map((error) => ({ path: error.path, error, text: error.path === "" ? error.message : `${error.path}: ${error.message}` })),
      holds: `The run goes on with revision ${core.revision}.`,
    };
  if (waiting === undefined) return undefined;
  const unconfirmed = waiting.unconfirmed === true;
  const title = unconfirmed && waiting.waits.length === 0 ? `Revision ${waiting.revision} of ${core.document} waits to be confirmed` : undefined;
  return {
    ...(unconfirmed && { confirms: waiting.revision }),
    title: title ?? waitingTitle(`Revision ${waiting.revision} of ${core.document}`, waiting.waits),
    waits: waiting.waits.map((obstacle) => ({ path: obstacle.path, ...(obstacle.id !== undefined && { id: obstacle.id }), text: obstacleText(obstacle) })),
    holds: unconfirmed ? `This run moves something: it goes on with revision ${core.revision} until who has the controls confirms the edit${waiting.waits.length > 0 ? ", and this changes" : ""}.` : waiting.waits.length > 0 ? `Until this changes, the run goes on with revision ${core.revision}.` : whenItGoesOn(core),
  };
}

const whenItGoesOn = (core: Core): string =>
  core.paused || isInterrupted(core) ? "It is delivered when the run goes on." : "It is delivered at the end of this macro step.";

/** Changes when the native model of the core does. */
export const modelKey = (core: Core): string => `${core.revision}/${core.model}`;
