// Whether an element of the document that is edited has a field.
import { entryOf } from "../../../shared/json";
import { useEditing } from "../editing";

export const useHas = (id: string, field: string): boolean => useEditing(({ session }) => entryOf(session?.view?.elements.get(id)?.fields, field) !== undefined);
