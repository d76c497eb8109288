// The reset of the cell: whether the page asks for it, and as an action of the palette.
import { refusalToReset } from "../../shared/cell/reset";
import { session, view } from "../client";
import type { Action } from "../edit/actions/action";
import { createStore, useSelected } from "../../page/store";

const asked = createStore<boolean, boolean>(false, (_, next) => next);

/** Whether the page asks if the cell is to be reset. */
export const useResetAsked = (): boolean => useSelected(asked, (now) => now);
export const askReset = (on: boolean): void => asked.dispatch(on);

export const cellActions: readonly Action[] = [
  {
    id: "reset_cell", name: "Reset the demo: cell and database, as at the start", keys: [], group: "Page", where: "page",
    when: () => (session.get().cell ? refusalToReset(session.get().cores) : "the server has no cell"),
    run: () => {
      view.dispatch({ type: "page", page: "cell" });
      askReset(true);
    },
  },
];
