// Actions on what is selected, and undo.
import { remove } from "../../../shared/edit/commands/remove";
import { view } from "../../client";
import { showProperties } from "../../panels/showProperties";
import { selectIds } from "../carryOut";
import { editing, perform } from "../editing";
import { openStateEditor } from "../forms/stateEditor";
import { focusSelected } from "../gestures/focused";
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

const removing = selectionAction({ id: "delete", name: "Delete", keys: ["Delete", "Backspace"], group: "Edit" }, ({ tree }, ids) => remove(tree, ids));

const selectAll: Action = {
  id: "select_all", name: "Select all in the same state", keys: ["Ctrl+A"], group: "Edit", where: "model",
  when: () => undefined,
  run: ({ tree, node, focus }) => {
    const parent = node === undefined || node === focus.id ? focus.id : (tree.elements.get(node)?.parent ?? focus.id);
    selectIds(tree.elements.get(parent)?.lists.children ?? []);
  },
};

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
  undo, redo,
  { ...removing, run: (situation) => { removing.run(situation); focusSelected(); } },
  properties, stateEditor, selectAll, selectNothing,
];
