// The places of a document, for what its run executes: what a link took over has ids of its own there, and stands as in the library.
import type { Node, RcmDocument, State } from "../model/model";
import type { Places, Place } from "./places";

/** `run`: the root of the native model of `document`. Nodes correspond by their names. */
export function runPlaces(document: RcmDocument, run: State, places: Places): Places {
  if (places.size === 0) return places;
  const library = new Map(document.library.map((state) => [state.name, state]));
  const found = new Map<string, Place>();
  const visit = (written: State, native: State): void => {
    const { id: owner, children } = library.get(written.link ?? "") ?? written;
    const byName = new Map<string, Node>(children.map((child) => [child.name, child]));
    for (const child of native.children) {
      const source = byName.get(child.name);
      const place = places.get(source?.id ?? "");
      if (child.id !== undefined && place !== undefined && (place.parent === undefined || place.parent === owner)) {
        const { parent: _, ...there } = place;
        found.set(child.id, native.id === undefined ? there : { ...there, parent: native.id });
      }
      if (source?.kind === "state" && child.kind === "state") visit(source, child);
    }
  };
  visit(document.root, run);
  return found;
}
