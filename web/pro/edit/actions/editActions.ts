// Actions on what is selected, and undo.
import { nameOfElement } from "../../../shared/edit/commands/command";
import { remove } from "../../../shared/edit/commands/remove";
import { rename } from "../../../shared/edit/commands/rename";
import { view } from "../../client";
import { unfold } from "../../layout/panels";
import { carryOut, selectIds } from "../carryOut";
import { editing, perform } from "../editing";
import { openStateEditor } from "../forms/stateEditor";
import { focusSelected } from "../gestures/focused";
import { placeOfSelection } from "../gestures/onScreen";
import { ask } from "../prompt";
import type { Situation } from "../situation";
import type { Action } from "./action";
import { selectionAction } from "./commandAction";

/** While an edit is on its way, the server knows better. */
function isKnownEmpty(of: "undo" | "redo"): boolean {
  const { session } = editing.get();
  return session?.pending.length === 0 && (session.depths?.[of] ?? (of === "redo" ? 0 : 1)) === 0;
}

const undo: Action = {
  id: "undo", name: "Undo", keys: ["Ctrl+Z"], group: "Edit", where: "untyped", repeats: true,
  when: () => (isKnownEmpty("undo") ? "there is nothing to undo" : undefined),
  run: () => perform({ undo: true }),
};

const redo: Action = {
  id: "redo", name: "Redo", keys: ["Ctrl+Y", "Ctrl+Shift+Z"], group: "Edit", where: "untyped", repeats: true,
  when: () => (isKnownEmpty("redo") ? "there is nothing to redo" : undefined),
  run: () => perform({ redo: true }),
};

/** Asks another name where the element is: at what is selected, or at another place of the screen. */
export function askName({ tree }: Situation, id: string, at: Pick<DOMRect, "x" | "y" | "width"> = placeOfSelection()): void {
  const value = nameOfElement(tree, id);
  const commit = (name: string): string | undefined => {
    if (name === value) return undefined;
    const now = editing.get().session?.view;
    if (now === undefined) return "the document is not here";
    const command = rename(now, id, name);
    if ("reason" in command) return command.reason;
    carryOut(command);
    return undefined;
  };
  ask({ kind: "name", label: `Name of ${value}`, at, value, commit });
}

const renaming: Action = {
  id: "rename", name: "Rename", keys: ["F2"], group: "Edit", where: "model",
  when: ({ one, ids }) => (one !== undefined ? undefined : ids.length > 1 ? "several are selected" : "nothing is selected"),
  run: (situation) => situation.one !== undefined && askName(situation, situation.one),
};

const removing = selectionAction({ id: "delete", name: "Delete", keys: ["Delete", "Backspace"], group: "Edit" }, ({ tree }, ids) => remove(tree, ids));

const selectAll: Action = {
  id: "select_all", name: "Select all beside it", keys: ["Ctrl+A"], group: "Edit", where: "model",
  when: () => undefined,
  run: ({ tree, node, focus }) => {
    const parent = node === undefined || node === focus.id ? focus.id : (tree.elements.get(node)?.parent ?? focus.id);
    selectIds(tree.elements.get(parent)?.lists.children ?? []);
  },
};

/** Where what is selected is shown and written. */
function showProperties(): void {
  unfold("right");
  const panel = document.querySelector('.side-right, [aria-label="Properties"]');
  panel?.querySelector<HTMLElement>("input, textarea, select, [contenteditable=true], button, a")?.focus();
}

const properties: Action = {
  id: "properties", name: "Properties", keys: ["Enter"], group: "Edit", where: "model",
  when: ({ one }) => (one === undefined ? "nothing is selected" : undefined),
  run: showProperties,
};

/** The wide form has the functions, ports and parameters of a state; of anything else, all is in the panel. */
const stateEditor: Action = {
  id: "state_editor", name: "State editor", keys: ["Shift+Enter"], group: "Edit", where: "model",
  when: ({ one, node }) => (one === undefined || one !== node ? "no state is selected" : undefined),
  run: (situation) => (situation.tree.elements.get(situation.one ?? "")?.kind === "state" ? openStateEditor() : properties.run(situation)),
};

const selectNothing: Action = {
  id: "select_none", name: "Select nothing", keys: ["Esc"], group: "Edit", where: "page",
  when: ({ ids }) => (ids.length === 0 ? "nothing is selected" : undefined),
  run: () => view.dispatch({ type: "select", selection: undefined }),
};

export const editActions: readonly Action[] = [
  undo, redo, renaming,
  { ...removing, run: (situation) => { removing.run(situation); focusSelected(); } },
  properties, stateEditor, selectAll, selectNothing,
];
