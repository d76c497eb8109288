// Which page is shown, in the address: nothing where it is that of the document that the address names, or else of the run.
import { addressWith, placeOfAddress } from "../shared/session/address";
import { pageOf } from "../shared/session/view";
import { view } from "./client";

/** Lets the address and the page go together; to be called once, when the document of the address is opened. */
export function followPage(): void {
  const wanted = pageOf(placeOfAddress(location.search).page);
  if (wanted !== undefined) view.dispatch({ type: "page", page: wanted });
  view.listen(() => {
    const { page } = view.get();
    const place = placeOfAddress(location.search);
    const written = page === "edit" || (page === "task" && place.edit === undefined) ? undefined : page;
    if (place.page !== written) history.replaceState(null, "", addressWith(location.search, { page: written }));
  });
}
