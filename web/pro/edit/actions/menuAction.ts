// The context menu: the actions that make sense for what is selected, by right click and by key.
import { elementOf } from "../../../shared/edit/tree";
import { placeOfSelection } from "../gestures/onScreen";
import { ask, type ScreenPoint } from "../prompt";
import type { Situation } from "../situation";
import { menuEntry, type Action } from "./action";

const kForPort = ["rename", "usages", "note", "breakpoint", "breakpoint_kind", "connect", "disconnect", "earlier", "later", "duplicate", "copy", "cut", "delete"];
const kForBarrier = ["rename", "usages", "note", "connect", "disconnect", "set_first", "earlier", "later", "group", "move_into", "move_out", "duplicate", "copy", "cut", "delete"];
const kForState = ["properties", "enter", "rename", "usages", "note", "breakpoint", "breakpoint_kind", "add_inside", "add_port", "connect", "set_first", "oracle", "earlier", "later", "group", "ungroup", "extract", "move_into", "move_out", "duplicate", "copy", "cut", "paste", "delete"];
const kForSeveral = ["group", "move_into", "move_out", "duplicate", "copy", "cut", "delete"];
const kForNothing = ["add_state", "add_barrier", "add_port", "paste", "select_all", "lay_out_anew", "keep_layout", "leave", "undo", "redo"];

function idsFor({ tree, ids, one }: Situation): readonly string[] {
  if (one === undefined) return ids.length > 0 ? kForSeveral : kForNothing;
  const { kind } = elementOf(tree, one);
  return kind === "port" ? kForPort : kind === "barrier" ? kForBarrier : kForState;
}

/** `all`: the actions there are. */
export function openMenu(all: readonly Action[], situation: Situation, at: ScreenPoint): void {
  const wanted = idsFor(situation);
  const entries = wanted.flatMap((id) => all.filter((action) => action.id === id)).map((action) => menuEntry(action, situation));
  ask({ kind: "menu", label: "Actions", at, entries });
}

/** `actions`: all others. */
export const menuAction = (actions: readonly Action[]): Action => ({
  id: "menu", name: "Menu of what is selected", keys: ["Shift+F10", "ContextMenu"], group: "Page", where: "model",
  when: () => undefined,
  run: (situation) => openMenu(actions, situation, placeOfSelection()),
});
