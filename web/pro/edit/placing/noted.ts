// The note that is being written, if one is.
import { idAt } from "../../../shared/model/identity";
import type { View } from "../../../shared/session/view";
import type { Laid } from "../../canvas/useDrawing";
import { createStore, useSelected } from "../../../page/store";

const written = createStore<string | undefined, string | undefined>(undefined, (_, id) => id);

/** The id of the element whose note is being written. */
export const useWritten = (): string | undefined => useSelected(written, (id) => id);

/** Begins to write the note of an element; nothing: ends that. */
export const editNote = (id: string | undefined): void => written.dispatch(id);

/** The element that a note would be about: what is selected, else the outermost state. */
export function noted({ drawing, tree }: Laid, { selection }: View): string | undefined {
  return idAt(tree, selection ?? { kind: "node", path: drawing.nodes[0]?.path ?? "" });
}
