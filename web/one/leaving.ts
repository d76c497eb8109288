// Whether the application may be left: edits that the server has not taken are lost by that, and of those that it has refused a person is to know, so they are
// asked first.
import { createStore, useSelected } from "../page/store";
import { isAllSaved } from "./editing";

/** What leaves it. */
type Leave = () => void;

const store = createStore<Leave | undefined, { readonly leave: Leave | undefined }>(undefined, (_, { leave }) => leave);
export const useIsLeaving = (): boolean => useSelected(store, (leave) => leave !== undefined);

/** Nothing is lost; otherwise a person is asked, and `leave` is called if they say so. */
export function mayLeave(leave: Leave): boolean {
  if (isAllSaved()) return true;
  store.dispatch({ leave });
  return false;
}

export const stay = (): void => store.dispatch({ leave: undefined });

export function leaveNow(): void {
  const leave = store.get();
  stay();
  leave?.();
}
