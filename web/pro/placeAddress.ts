// The place in the model in the address: the state that is entered, the selection, and the panel below. A selection is written over the one before
// once it rests, a panel at once; a state that is entered is a further entry of the browser's history.
import type { ModelTree } from "../shared/model/modelTree";
import { addressWith, placeOfAddress, type Place } from "../shared/session/address";
import { isElsewhere, isSamePlace, pageOfPlace, placeInModel, toPlace, type PlaceInModel } from "../shared/session/placeInAddress";
import { momentOf } from "../shared/past/moment";
import { session, shownSession, view } from "./client";
import { editedTree, editing, showTop } from "./edit/editing";
import { runTree } from "./live/runTree";

/** A selection is written once it stays for this time: browsers limit how often an address changes [ms]. */
const kRest = 200;

const first = view.get().drawer;
/** What the address asks for and the page does not show yet. */
let wanted: Place | undefined;
/** What is written once it has rested. */
let resting: { readonly place: PlaceInModel; readonly timer: ReturnType<typeof setTimeout> } | undefined;
let isDue = false;

const shownTree = (): ModelTree | undefined => (view.get().page === "edit" ? editedTree() : runTree());
const isOfSame = (a: Place, b: Place): boolean => pageOfPlace(a) === pageOfPlace(b) && a.edit === b.edit && (a.run === undefined || a.run === b.run);

/** Whether the run is shown, at the moment that the address names: its model is that of the moment. */
function isRunThere({ run }: Place): boolean {
  const { watched, model, past } = session.get();
  const isAtMoment = past !== undefined || momentOf(placeOfAddress(location.search).at) === undefined;
  return (run === undefined || run === watched) && model !== undefined && isAtMoment;
}

/** Shows what is wanted, once what it is in is there. Whether nothing is wanted any more. */
function arrive(): boolean {
  if (wanted === undefined) return true;
  if (!isOfSame(wanted, placeOfAddress(location.search))) {
    wanted = undefined;
    return true;
  }
  const isThere = pageOfPlace(wanted) === view.get().page && (view.get().page === "edit" ? wanted.edit === editing.get().document : isRunThere(wanted));
  if (!isThere || shownTree() === undefined) return false;
  const place = wanted;
  wanted = undefined;
  if (view.get().page === "edit" && editing.get().top !== place.top) showTop(place.top);
  const tree = shownTree();
  if (tree !== undefined) view.dispatch(toPlace(tree, place, first));
  return true;
}

/** The address as it was found last: of another run, page or document, what follows is no step of its own. */
let last: Place = placeOfAddress(location.search);

function write(): void {
  const before = placeOfAddress(location.search);
  const now = placeInModel(view.get(), first, editing.get().top);
  const isStep = isOfSame(last, before) && !view.get().follow && isElsewhere(shownTree(), before, now);
  last = before;
  // What changes elsewhere does not begin its time anew.
  if (resting !== undefined && isSamePlace(resting.place, now)) return;
  giveUp();
  if (isSamePlace(before, now)) return;
  if (isStep) history.pushState(null, "", addressWith(location.search, now));
  else if (before.below !== now.below) put(now);
  else resting = { place: now, timer: setTimeout(writePlace, kRest) };
}

const put = (place: PlaceInModel): void => history.replaceState(null, "", addressWith(location.search, place));

function giveUp(): void {
  clearTimeout(resting?.timer);
  resting = undefined;
}

/** Writes a selection that rests, before another entry of the browser's history begins. */
export function writePlace(): void {
  const place = resting?.place;
  giveUp();
  if (place !== undefined && wanted === undefined) put(place);
}

/** Looks once for all that changes at a time. */
function look(): void {
  if (isDue) return;
  isDue = true;
  queueMicrotask(() => {
    isDue = false;
    if (arrive()) write();
  });
}

/** Lets the address and the place go together; to be called once, before what else reads the address. */
export function followPlace(): void {
  const { in: focus, sel, why, top, below } = last;
  // The cell can be moved by hand without a run, too.
  if (below === "manual") view.dispatch({ type: "drawer", drawer: below });
  if (!isSamePlace({ in: focus, sel, why, top, below: below === "manual" ? undefined : below }, {})) wanted = last;
  for (const store of [view, shownSession, editing]) store.listen(look);
  // Whoever waits for a model sees each change; else a run would have the address read with each of its steps.
  session.listen(() => wanted !== undefined && look());
  // Before the page, the run and the moment follow it.
  addEventListener(
    "popstate",
    () => {
      giveUp();
      last = wanted = placeOfAddress(location.search);
      look();
    },
    { capture: true },
  );
}
