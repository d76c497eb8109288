// Actions on the run of the document that is edited, for the palette: what its bars do, chosen by name.
import { allowedBeside, runOfDocument } from "../../shared/live/shownRun";
import { isOver, type Command } from "../../shared/run/controls";
import { commandable, watchedCore } from "../../shared/session/session";
import { follow, session, view } from "../client";
import type { Action } from "../edit/actions/action";
import { command as carryOut } from "../panels/startAsk";

const runOf = (document: string) => runOfDocument(watchedCore(session.get()), document);

/** They have no key here: a key that moves a robot acts on the page of the run alone. */
const runAction = (command: Command, name: string): Action => ({
  id: `live_${command}`, name, keys: [], group: "Page", where: "page",
  when: ({ document }) => {
    if (runOf(document) === undefined) return "no run of this document is watched";
    return allowedBeside(commandable(session.get()), document).has(command) ? undefined : "the watched run does not take this now";
  },
  run: () => carryOut(command),
});

const following: Action = {
  id: "follow", name: "Follow edits with the run, or no longer", keys: [], group: "Page", where: "page",
  when: ({ document }) => {
    const core = runOf(document);
    if (core === undefined) return "no run of this document is watched";
    return isOver(core) ? "the run is over" : undefined;
  },
  run: ({ document }) => void follow(runOf(document)?.live !== true),
};

const showing: Action = {
  id: "run_shown", name: "Show the run on the drawing, or hide it", keys: [], group: "Page", where: "page",
  when: ({ document }) => (runOf(document) === undefined ? "no run of this document is watched" : undefined),
  run: ({ view: { runShown } }) => view.dispatch({ type: "run_shown", shown: !runShown }),
};

export const liveActions: readonly Action[] = [
  runAction("start", "Start the run of this document"), runAction("resume", "Resume the run of this document"),
  runAction("micro", "Micro step of the run"), runAction("macro", "Macro step of the run"), following, showing,
];
