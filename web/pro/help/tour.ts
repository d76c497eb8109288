// The tour: the document that it builds, which is in the address (`tour=NAME`).
import { freeDocumentName } from "../../shared/documents/names";
import { namesOf } from "../../shared/documents/listed";
import { addressWith, placeOfAddress } from "../../shared/session/address";
import { attempt, session } from "../client";
import { create } from "../documents/actions";
import { createStore, useSelected } from "../../page/store";
import { showHelp } from "./help";

const store = createStore<string | undefined, string | undefined>(undefined, (_, next) => next);

/** Name of its document; nothing: there is no tour. */
export const useTour = (): string | undefined => useSelected(store, (now) => now);

function show(document: string | undefined): void {
  store.dispatch(document);
  history.replaceState(null, "", addressWith(location.search, { tour: document }));
}

/** Begins with a document of its own. */
export function startTour(): void {
  const name = freeDocumentName("first-task", namesOf(session.get().documents));
  showHelp(undefined);
  void attempt(async () => {
    await create(name);
    show(name);
  });
}

export const endTour = (): void => show(undefined);

/** The tour that the address names goes on; to be called once. */
export function tourFromAddress(): void {
  store.dispatch(placeOfAddress(location.search).tour);
}
