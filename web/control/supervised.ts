// Whether the runs that this page begins need the person at the controls: off at first, and again once the controls are gone.
import { controls, listenToControls } from "./page";
import { createStore, useSelected } from "../page/store";

const store = createStore<boolean, boolean>(false, (_, next) => next);
listenToControls(() => controls.get().kind !== "held" && store.dispatch(false));

export const isSupervised = (): boolean => store.get();
export const useSupervised = (): boolean => useSelected(store, (on) => on);
export const supervise = (on: boolean): void => store.dispatch(on);
