// Actions that are one command each: they can be done if the command has a change.
import type { Command } from "../../../shared/edit/commands/command";
import { carryOut } from "../carryOut";
import type { Situation } from "../situation";
import type { Action } from "./action";

/** Its name and keys. They act in the model unless it says another place. */
export type ActionSpec = Pick<Action, "id" | "name" | "group"> & Partial<Pick<Action, "keys" | "where" | "repeats">>;

const kNothing: Command = { reason: "nothing is selected" };

const reasonOf = (command: Command): string | undefined => ("reason" in command ? command.reason : undefined);

/** `make`: the command in a situation. */
export const commandAction = (spec: ActionSpec, make: (situation: Situation) => Command): Action => ({
  keys: [], where: "model", ...spec, when: (situation) => reasonOf(make(situation)), run: (situation) => void carryOut(make(situation)),
});

/** The same for one selected element. */
export const elementAction = (spec: ActionSpec, make: (situation: Situation, id: string) => Command): Action =>
  commandAction(spec, (situation) => (situation.one === undefined ? (situation.ids.length > 1 ? { reason: "several are selected" } : kNothing) : make(situation, situation.one)));

/** The same for all that are selected. */
export const selectionAction = (spec: ActionSpec, make: (situation: Situation, ids: readonly string[]) => Command): Action =>
  commandAction(spec, (situation) => (situation.ids.length === 0 ? kNothing : make(situation, situation.ids)));
