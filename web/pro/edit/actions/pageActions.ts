// Actions on the page around the document; the page itself takes their keys.
import { allowed, type Command } from "../../../shared/run/controls";
import { watchedCore } from "../../../shared/session/session";
import { shortcuts, type Shortcut } from "../../../shared/session/shortcuts";
import { session, view } from "../../client";
import { showLegend } from "../../canvas/legend/Legend";
import { toggleFolded } from "../../layout/panels";
import { focusSearch } from "../../panels/SearchBox";
import { command as carryOut } from "../../panels/startAsk";
import { showRuns } from "../../runs/actions";
import type { Action } from "./action";

const keysOf = (shortcut: Shortcut): readonly string[] => shortcuts.find((entry) => entry.shortcut === shortcut)?.keys ?? [];

const pageAction = (shortcut: Shortcut, name: string, act: () => void): Action => ({
  id: shortcut, name, keys: keysOf(shortcut), group: "Page", where: "page", when: () => undefined, run: act,
});

const runCommand = (command: Command & Shortcut, name: string): Action => ({
  ...pageAction(command, name, () => carryOut(command)),
  when: () => (allowed(watchedCore(session.get())).has(command) ? undefined : "the watched run does not take this now"),
});

export const pageActions: readonly Action[] = [
  runCommand("pause", "Pause the watched run"), runCommand("stop", "Stop the watched run"),
  pageAction("search", "Search states, ports and code", focusSearch),
  pageAction("runs", "Runs that the server has stored", () => showRuns(true)),
  pageAction("fold_left", "Fold the left panel away, or bring it back", () => toggleFolded("left")),
  pageAction("fold_right", "Fold the right panel away, or bring it back", () => toggleFolded("right")),
  { id: "legend", name: "Legend: what the signs of the drawing mean", keys: [], group: "Page", where: "page", when: () => undefined, run: () => showLegend(true) },
  pageAction("help", "Show all keys", () => view.dispatch({ type: "help", shown: true })),
];
