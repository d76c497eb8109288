// A change of a time line as it is made in these tests.
import { apply, type Operation } from "../../shared/edit/apply";
import type { Command } from "../../shared/edit/commands/command";
import { plain } from "../../shared/edit/exact";
import { Refusal } from "../../shared/edit/refusal";
import type { Tree } from "../../shared/edit/tree";
import type { Supplies } from "../../shared/timeline/changes/draft";
import { skills } from "../skills/fixture";

let count = 0;
export const supplies: Supplies = { newId: () => `n${++count}`, documents: [skills] };

/** The document after the command, and what is selected then. Throws what keeps it from being made. */
export function after(tree: Tree, command: Command): { readonly tree: Tree; readonly id: string } {
  if ("reason" in command) throw new Error(command.reason);
  if (!("operations" in command.change)) throw new Error("the server makes this change");
  const applied = apply(tree, { operations: plain<readonly Operation[]>(command.change.operations) });
  if (applied instanceof Refusal) throw applied;
  return { tree: applied.tree, id: command.select ?? "" };
}
