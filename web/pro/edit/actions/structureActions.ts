// Actions on the structure: groups, the library, the order, and where things are.
import { setFirst } from "../../../shared/edit/commands/first";
import { homesFor } from "../../../shared/edit/commands/homes";
import { extract, group, nameForGroup, nameInLibrary, reasonAgainstGroup, ungroup } from "../../../shared/edit/commands/group";
import { moveInOrder, moveInto, moveOut } from "../../../shared/edit/commands/move";
import type { Command } from "../../../shared/edit/commands/command";
import { outermost } from "../../../shared/edit/commands/references";
import { elementOf, listOf, type Tree } from "../../../shared/edit/tree";
import { view } from "../../client";
import { carryOut } from "../carryOut";
import { editedDocument } from "../editing";
import { goToField } from "../goToField";
import { placeOfSelection } from "../gestures/onScreen";
import { ask, type MenuEntry } from "../prompt";
import type { Action } from "./action";
import { elementAction, selectionAction } from "./commandAction";

/** Asks a name, and carries out the command that it makes. */
function askNameFor(label: string, value: string, make: (tree: Tree, name: string) => Command): void {
  const commit = (name: string): string | undefined => {
    const tree = editedDocument();
    const command = tree === undefined ? { reason: "the document is not here" } : make(tree, name);
    if ("reason" in command) return command.reason;
    carryOut(command);
    return undefined;
  };
  ask({ kind: "name", label, at: placeOfSelection(), value, commit });
}

const grouping: Action = {
  id: "group", name: "Group into a new state", keys: ["Ctrl+G"], group: "Structure", where: "model",
  when: ({ tree, ids }) => reasonAgainstGroup(tree, ids),
  run: ({ tree, ids }) => askNameFor("Name of the new state", nameForGroup(tree, ids), (now, name) => group(now, ids, name)),
};

const extracting: Action = {
  ...elementAction({ id: "extract", name: "Extract into the library", group: "Structure" }, ({ tree }, id) => extract(tree, id, nameInLibrary(tree, id))),
  run: ({ tree, one }) => one !== undefined && askNameFor("Name in the library", nameInLibrary(tree, one), (now, name) => extract(now, one, name)),
};

const deciding: Action = {
  id: "oracle", name: "Let an oracle decide where it begins", keys: [], group: "Structure", where: "untyped",
  when: ({ tree, one }) => (one === undefined ? "no state is selected" : listOf(tree, one, "children").length === 0 ? "it has no states inside" : undefined),
  run: ({ one }) => one !== undefined && goToField(one, ["oracle"]),
};

/** The states to move into; the last entry says how many others there are, and how to reach them. */
function homeEntries(tree: Tree, ids: readonly string[]): readonly MenuEntry[] {
  const { shown, more } = homesFor(tree, ids);
  if (shown.length === 0) return [{ name: "No other state", reason: "there is none to move into", run: () => undefined }];
  const entries = shown.map(({ id, path }) => ({ name: path, run: () => void carryOut(moveInto(tree, ids, id)) }));
  return more === 0 ? entries : [...entries, { name: `${more} more`, reason: "cut it, and paste it where you want it", run: () => undefined }];
}

const moving: Action = {
  id: "move_into", name: "Move into …", keys: [], group: "Structure", where: "model",
  when: ({ tree, ids }) => (ids.length === 0 ? "nothing is selected" : ids.some((id) => elementOf(tree, id).list !== "children") ? "only states and barriers inside of a state move" : undefined),
  run: ({ tree, ids }) => {
    ask({ kind: "menu", label: "Move into", at: placeOfSelection(), entries: homeEntries(tree, outermost(tree, ids)) });
  },
};

const enter: Action = {
  id: "enter", name: "Enter the state", keys: ["Ctrl+Enter"], group: "Walk", where: "model",
  when: ({ view: { selection } }) => (selection?.kind === "node" ? undefined : "no state is selected"),
  run: ({ view: { selection } }) => selection?.kind === "node" && view.dispatch({ type: "enter", path: selection.path }),
};

const leave: Action = {
  id: "leave", name: "Show the state around it", keys: ["Ctrl+Backspace"], group: "Walk", where: "model",
  when: ({ model, focus }) => (model.get(focus.path)?.parent === undefined ? "the whole is shown" : undefined),
  run: ({ model, focus }) => view.dispatch({ type: "enter", path: model.get(model.get(focus.path)?.parent ?? "")?.path }),
};

export const structureActions: readonly Action[] = [
  grouping,
  elementAction({ id: "ungroup", name: "Ungroup", keys: ["Ctrl+Shift+G"], group: "Structure" }, ({ tree }, id) => ungroup(tree, id)),
  extracting,
  elementAction({ id: "set_first", name: "Begin here", group: "Structure" }, ({ tree }, id) => setFirst(tree, id)),
  deciding,
  moving,
  selectionAction({ id: "move_out", name: "Move out of its state", group: "Structure" }, ({ tree }, ids) => moveOut(tree, ids)),
  elementAction({ id: "earlier", name: "Evaluate earlier", keys: ["Alt+ArrowUp"], group: "Structure", repeats: true }, ({ tree }, id) => moveInOrder(tree, id, "earlier")),
  elementAction({ id: "later", name: "Evaluate later", keys: ["Alt+ArrowDown"], group: "Structure", repeats: true }, ({ tree }, id) => moveInOrder(tree, id, "later")),
  enter,
  leave,
];
