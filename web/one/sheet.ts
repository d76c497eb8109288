// On small screens the library and the settings lie over the tasks, one at a time.
import { createStore, useSelected } from "../page/store";

export type Sheet = "library" | "panel";

const store = createStore<Sheet | undefined, { readonly sheet: Sheet | undefined }>(undefined, (_, { sheet }) => sheet);
export const useSheet = (): Sheet | undefined => useSelected(store, (sheet) => sheet);
export const showSheet = (sheet: Sheet | undefined): void => store.dispatch({ sheet });
