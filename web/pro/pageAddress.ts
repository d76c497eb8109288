// Which page is shown, in the address: nothing where it is that of the document that the address names, or else of the run. The browser's Back leads to
// the page before.
import { addressWith, placeOfAddress } from "../shared/session/address";
import { pageOfPlace } from "../shared/session/placeInAddress";
import { pageOf } from "../shared/session/view";
import { view } from "./client";
import { editing, openDocument } from "./edit/editing";
import { writePlace } from "./placeAddress";

/** Lets the address and the page go together; to be called once, when the document of the address is opened. */
export function followPage(): void {
  const wanted = pageOf(placeOfAddress(location.search).page);
  if (wanted !== undefined) view.dispatch({ type: "page", page: wanted });
  let shown = view.get().page;
  view.listen(() => {
    const { page } = view.get();
    // Something else has changed: the address may be ahead, by the browser's Back.
    if (page === shown) return;
    shown = page;
    const place = placeOfAddress(location.search);
    const edit = page === "edit" ? editing.get().document : place.edit;
    const written = page === "edit" || (page === "task" && edit === undefined) ? undefined : page;
    if (place.page === written && place.edit === edit) return;
    writePlace();
    history.pushState(null, "", addressWith(location.search, { page: written, edit }));
  });
  addEventListener("popstate", () => {
    const place = placeOfAddress(location.search);
    const page = pageOfPlace(place);
    if (page === "edit" && place.edit !== undefined && place.edit !== editing.get().document) openDocument(place.edit);
    else if (page !== view.get().page) view.dispatch({ type: "page", page });
  });
}
