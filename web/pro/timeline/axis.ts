// What the time line measures by, also in the address (`axis=steps`; else seconds).
import type { Measure } from "../../shared/runs/scale";
import { addressWith, placeOfAddress } from "../../shared/session/address";
import { createStore, useSelected } from "../../page/store";

const measureOf = (axis: string | undefined): Measure => (axis === "steps" ? "steps" : "seconds");

const store = createStore<Measure, Measure>(measureOf(placeOfAddress(location.search).axis), (_, next) => next);

export const useMeasure = (): Measure => useSelected(store, (now) => now);

export function measureBy(measure: Measure): void {
  store.dispatch(measure);
  history.replaceState(null, "", addressWith(location.search, { axis: measure === "steps" ? "steps" : undefined }));
}
