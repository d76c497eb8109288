// Whether the page shows how a phone becomes a display; also as an action of the palette.
import type { Action } from "../edit/actions/action";
import { createStore, useSelected } from "../../page/store";

const shown = createStore<boolean, boolean>(false, (_, next) => next);

export const usePairing = (): boolean => useSelected(shown, (now) => now);
export const askPairing = (on: boolean): void => shown.dispatch(on);

export const pairingActions: readonly Action[] = [
  { id: "pair_phone", name: "Pair a phone as a display", keys: [], group: "Page", where: "page", when: () => undefined, run: () => askPairing(true) },
];
