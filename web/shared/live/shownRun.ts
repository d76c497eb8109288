// Which run is shown on the drawing of the document that is edited.
import type { Core } from "../../generated/messages";
import { allowed, isOver, type Command } from "../run/controls";

/** The watched run, if it is one of this document: a run is never shown in another one. */
export const runOfDocument = (watched: Core | undefined, document: string | undefined): Core | undefined =>
  watched !== undefined && watched.document === document ? watched : undefined;

/** The newest run of a document, one that is not over if there is any. */
export function newestRun(cores: readonly Core[], document: string): Core | undefined {
  const all = cores.filter((core) => core.document === document);
  return all.filter((core) => !isOver(core)).at(-1) ?? all.at(-1);
}

/**
 * The run to which the page turns when it opens a document. While the watched run is of this document, or of another one and under way, it stays:
 * pause and stop act on the watched run, and nobody has turned from it.
 */
export function runToTurnTo(cores: readonly Core[], watched: Core | undefined, document: string): Core | undefined {
  if (watched?.document === document) return undefined;
  return watched === undefined || watched.status === "ready" || isOver(watched) ? newestRun(cores, document) : undefined;
}

/** The commands that the core takes from a page that edits `edited`; nothing: from another page. While another document is edited, nothing starts the
 *  run or moves it on, as it is not seen. It can be paused and stopped. */
export function allowedBeside(core: Core | undefined, edited: string | undefined): ReadonlySet<Command> {
  const commands = allowed(core);
  if (edited === undefined || core?.document === edited) return commands;
  return new Set([...commands].filter((command) => command === "pause" || command === "stop"));
}
