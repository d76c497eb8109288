// What a page starts: one run by one press, whichever of its buttons and keys it is.
import { kSamePress, onlyOnce } from "../shared/onlyOnce";
import { createStore, useSelected } from "./store";

const createBusy = () => createStore<boolean, boolean>(false, (_, isBusy) => isBusy);
const [making, going] = [createBusy(), createBusy()];
const after = (time: number, act: () => void): void => void setTimeout(act, time);
const make = onlyOnce({ settle: kSamePress, after, onChange: making.dispatch });
let pressed = -kSamePress;

/** Makes a run, or starts one by a button that is gone then; the second click of a double click does nothing. */
export function makeOnce(act: () => Promise<unknown>): Promise<void> {
  if (!making.get()) pressed = performance.now();
  return make(act);
}
/** Starts or resumes a run that is there, unless that is on its way. */
export const goOnce = onlyOnce({ settle: 0, after, onChange: going.dispatch });

/** Whether a press began something just now: what takes the place of its button is not meant by it. */
export const isSamePress = (): boolean => performance.now() - pressed < kSamePress;

export const useIsMaking = (): boolean => useSelected(making, (isBusy) => isBusy);
export const useIsGoing = (): boolean => useSelected(going, (isBusy) => isBusy);
