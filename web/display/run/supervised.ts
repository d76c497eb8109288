// Whether the runs that this page begins need the person at the controls: the phone is in the hand of who stands at the robot.
import { createStore, useSelected } from "../../page/store";

const store = createStore<boolean, boolean>(false, (_, next) => next);

export const isSupervised = (): boolean => store.get();
export const useSupervised = (): boolean => useSelected(store, (on) => on);
export const supervise = (on: boolean): void => store.dispatch(on);
