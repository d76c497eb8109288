// Carries a command out. One that has nothing to do changes nothing.
import type { Command } from "../../../shared/edit/commands/command";
import { perform } from "../editing";

export function carryOut(command: Command): void {
  if ("change" in command) perform(command.change);
}
