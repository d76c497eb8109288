// Which topic of the help is shown, also in the address (`help=TOPIC`).
import { placeOfCode } from "../../shared/help/errorCodes";
import { topicOf } from "../../shared/help/topics";
import { addressWith, placeOfAddress } from "../../shared/session/address";
import { createStore, useSelected } from "../../page/store";

export interface HelpPlace {
  readonly topic: string;
  /** Within it. */
  readonly term?: string;
}

const store = createStore<HelpPlace | undefined, HelpPlace | undefined>(undefined, (_, next) => next);

export const useHelp = (): HelpPlace | undefined => useSelected(store, (now) => now);

export const isHelpShown = (): boolean => store.get() !== undefined;

/** Nothing: closes it. */
export function showHelp(place: HelpPlace | undefined): void {
  store.dispatch(place);
  history.replaceState(null, "", addressWith(location.search, { help: place?.topic }));
}

/** Explains the code of an error. */
export function explainCode(code: string): void {
  const place = placeOfCode(code);
  if (place !== undefined) showHelp(place);
}

/** The topic that the address names is shown; to be called once. */
export function helpFromAddress(): void {
  const { help } = placeOfAddress(location.search);
  if (help !== undefined && topicOf(help) !== undefined) store.dispatch({ topic: help });
}
