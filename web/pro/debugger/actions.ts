// The debugger's commands as actions of the page that edits, as entries of menus, and by their keys.
import { keysOf, shortcuts, type DebugShortcut, type Shortcut } from "../../shared/session/shortcuts";
import { problem, view } from "../client";
import type { Action } from "../edit/actions/action";
import type { MenuEntry } from "../edit/prompt";
import { refuse } from "../edit/say";
import { debugCommands, type DebugCommand } from "./commands";

const kKeys: ReadonlySet<Shortcut> = new Set(debugCommands.flatMap(({ shortcut }) => shortcut ?? []));
export const isDebugShortcut = (shortcut: Shortcut): shortcut is DebugShortcut => kKeys.has(shortcut);

/** Requires the id of a command. */
export function commandOf(id: string): DebugCommand {
  const found = debugCommands.find((command) => command.id === id);
  if (found === undefined) throw new Error(`the debugger has no ${id}`);
  return found;
}

/** Does it, or tells why not. */
export function runDebugCommand({ when, run }: DebugCommand): void {
  const reason = when();
  if (reason === undefined) run();
  else if (view.get().page === "edit") refuse(reason);
  else problem(`Not done: ${reason}.`);
}

export function runCommandOf(shortcut: DebugShortcut): void {
  const command = debugCommands.find((each) => each.shortcut === shortcut);
  if (command !== undefined) runDebugCommand(command);
}

/** The keys of a command, for its button. */
export const keysOfCommand = ({ shortcut }: DebugCommand): string => (shortcut === undefined ? "" : keysOf(shortcut));

export const menuEntryOf = (command: DebugCommand): MenuEntry => ({ name: command.name, keys: keysOfCommand(command), reason: command.when(), run: () => runDebugCommand(command) });

/** Their keys are the page's. */
export const debuggerActions: readonly Action[] = debugCommands.map((command) => ({
  id: command.id, name: command.name, group: "Debug", where: "page",
  keys: shortcuts.find(({ shortcut }) => shortcut === command.shortcut)?.keys ?? [],
  when: () => command.when(), run: () => runDebugCommand(command),
}));
