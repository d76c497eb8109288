// Whether the drawing of a run follows it, in the address (`follow=1`).
import { addressWith, placeOfAddress } from "../../shared/session/address";
import { view } from "../client";

/** Lets the address and the page go together; to be called once. */
export function keepFollowing(): void {
  if (placeOfAddress(location.search).follow !== undefined) view.dispatch({ type: "follow", on: true });
  view.listen(() => {
    const follow = view.get().follow ? "1" : undefined;
    if (placeOfAddress(location.search).follow !== follow) history.replaceState(null, "", addressWith(location.search, { follow }));
  });
}
