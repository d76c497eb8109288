// Where people have placed what the document has, and what they have noted.
import { placesIn, type Places } from "../../../shared/drawing/places";
import { notesOf } from "../../../shared/edit/commands/placing";
import type { Tree } from "../../../shared/edit/tree";
import { editing, useEditing } from "../editing";

const placesOf = (tree: Tree | undefined): Places => placesIn(tree?.fields["layout"]);

/** The same object as long as no place changes. */
export const editedPlaces = (): Places => placesOf(editing.get().session?.view);

export const useEditedPlaces = (): Places => useEditing((now) => placesOf(now.session?.view));

const kNone: Readonly<Record<string, string>> = {};

/** Notes by the ids of elements. */
export const useNotes = (): Readonly<Record<string, string>> => useEditing((now) => (now.session?.view === undefined ? kNone : notesOf(now.session.view)));
