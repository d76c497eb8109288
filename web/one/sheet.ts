// On small screens the library and the settings lie over the tasks, one at a time.
import { createStore, useSelected } from "../page/store";

export type Sheet = "library" | "panel";

const store = createStore<Sheet | undefined, { readonly sheet: Sheet | undefined }>(undefined, (_, { sheet }) => sheet);
/** Whether it is one now, on a small screen: who opens it is led into it. */
export const liesOver = (element: HTMLElement): boolean => getComputedStyle(element).position === "absolute";
export const useSheet = (): Sheet | undefined => useSelected(store, (sheet) => sheet);

/** What had the focus when the first of them was opened. */
let opener: HTMLElement | undefined;
export const openerOfSheet = (): HTMLElement | undefined => (opener?.isConnected === true ? opener : undefined);

export function showSheet(sheet: Sheet | undefined): void {
  if (store.get() === undefined) opener = document.activeElement instanceof HTMLElement ? document.activeElement : undefined;
  store.dispatch({ sheet });
}
