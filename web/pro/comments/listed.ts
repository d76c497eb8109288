// Whether the open comments of the document are listed under the drawing.
import { createStore, useSelected } from "../../page/store";

const store = createStore<boolean, boolean>(false, (_, listed) => listed);

export const useCommentsListed = (): boolean => useSelected(store, (listed) => listed);

export const listComments = (listed: boolean): void => store.dispatch(listed);
export const toggleComments = (): void => store.dispatch(!store.get());
