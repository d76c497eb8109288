// Which view the page shows: the fragment of its address.
import { useSyncExternalStore } from "react";
import { hashOf, placeOf, type PendantPlace } from "../shared/pendant/view";

export const ownPlace = (): PendantPlace => placeOf(location.hash);

const listen = (listener: () => void): (() => void) => {
  addEventListener("hashchange", listener);
  return () => removeEventListener("hashchange", listener);
};

export const usePlace = <T>(select: (place: PendantPlace) => T): T => useSyncExternalStore(listen, () => select(ownPlace()));

/** The parts that are not named stay. */
export const goTo = (change: Partial<PendantPlace>): void => location.assign(hashOf({ ...ownPlace(), ...change }));
