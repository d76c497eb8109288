// The run that is to be made and needs arguments, or shall have some.
import { areOptional, type RunParameter } from "../../shared/arguments/parameters";
import { attempt } from "../client";
import { makeRun, parametersOf } from "../runCommands";
import { makeStarted } from "../panels/startAsk";
import { makeOnce } from "../../page/starting";
import { createStore, useSelected } from "../../page/store";

export interface Asked {
  /** Name of the document. */
  readonly document: string;
  readonly parameters: readonly RunParameter[];
}

const store = createStore<Asked | undefined, Asked | undefined>(undefined, (_, asked) => asked);

/** What the form for arguments asks for; nothing: it is not open. */
export const useAsked = (): Asked | undefined => useSelected(store, (asked) => asked);

export const closeForm = (): void => store.dispatch(undefined);

/** Makes a run of the document as it is now, and starts it if asked; asks for arguments if it needs some, or if it has parameters and is to ask `always`. */
export function requestRun(document: string, always: boolean, start = false): Promise<void> {
  const request = () =>
    attempt(async () => {
      const parameters = await parametersOf(document);
      if (parameters.length > 0 && (always || !areOptional(parameters))) store.dispatch({ document, parameters });
      else if (start) await makeStarted(document, {});
      else await makeRun(document, false, {});
    });
  // To ask makes nothing: two presses open one form.
  return always ? request() : makeOnce(request);
}
