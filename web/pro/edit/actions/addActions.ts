// Actions that add something.
import { addBarrier, addLibraryState, addPort, addState } from "../../../shared/edit/commands/add";
import { placeAt, placeIn, type PlaceOrReason } from "../../../shared/edit/commands/place";
import type { Situation } from "../situation";
import { newId } from "../../../shared/newId";
import { commandAction } from "./commandAction";

/** Where what is added goes: by the selection, else into the state that is shown. */
export const placeFor = ({ tree, node, focus }: Situation): PlaceOrReason => (node === undefined || node === focus.id ? placeIn(tree, focus.id) : placeAt(tree, node));

export const addActions = [
  commandAction({ id: "add_state", name: "Add state", keys: ["Insert", "Alt+S"], group: "Add" }, (s) => addState(s.tree, placeFor(s), newId)),
  commandAction({ id: "add_inside", name: "Add state inside", keys: ["Shift+Insert", "Alt+Shift+S"], group: "Add" }, (s) => addState(s.tree, placeIn(s.tree, s.node ?? s.focus.id), newId)),
  commandAction({ id: "add_barrier", name: "Add barrier", keys: ["Alt+B"], group: "Add" }, (s) => addBarrier(s.tree, placeFor(s), newId)),
  commandAction({ id: "add_port", name: "Add port", keys: ["Alt+P"], group: "Add" }, (s) => addPort(s.tree, s.node ?? s.focus.id, newId)),
  commandAction({ id: "add_library_state", name: "Add library state", group: "Library", where: "untyped" }, (s) => addLibraryState(s.tree, newId)),
] as const;
