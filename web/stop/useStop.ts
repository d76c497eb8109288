// What a component reads of the stop of this page.
import { useSyncExternalStore } from "react";
import type { StopState } from "../shared/stop/state";
import { stop } from "./page";

/** The part that `select` reads; it must return the same object while nothing changed. */
export const useStop = <T>(select: (state: StopState) => T): T => useSyncExternalStore(stop.listen, () => select(stop.get()));
