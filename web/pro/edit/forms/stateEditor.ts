// Whether the state editor (thesis, Fig. A.2) is open: the selected state's interface, functions and ports in one wide form over the drawing.
import { createStore, useSelected } from "../../../page/store";

const shown = createStore<boolean, boolean>(false, (_, next) => next);

export const openStateEditor = (): void => shown.dispatch(true);
export const closeStateEditor = (): void => shown.dispatch(false);
export const useStateEditor = (): boolean => useSelected(shown, (isShown) => isShown);
