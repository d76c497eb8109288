// What the server finds wrong with a field of the document that is edited.
import type { ServerError } from "../../../generated/messages";
import { placesOf, type ErrorPlace } from "../../../shared/edit/places";
import type { EditSession } from "../../../shared/edit/session";
import { useEditing } from "../editing";

const kNone: readonly ServerError[] = [];
const kNoPlaces: ReadonlyMap<string, readonly ErrorPlace[]> = new Map();

let last: { readonly of: EditSession["errors"]; readonly places: ReadonlyMap<string, readonly ErrorPlace[]>; readonly fields: Map<string, readonly ServerError[]> } | undefined;

function placed(session: EditSession | undefined) {
  if (session?.confirmed === undefined) return { places: kNoPlaces, fields: undefined };
  if (last?.of !== session.errors) last = { of: session.errors, places: placesOf(session.confirmed.tree, session.errors), fields: new Map() };
  return last;
}

/** Of an element as a whole, with an empty `field`. The same list as long as the errors are the same. */
function errorsAt(session: EditSession | undefined, id: string, field: string): readonly ServerError[] {
  const { places, fields } = placed(session);
  const of = places.get(id);
  if (of === undefined || fields === undefined) return kNone;
  const key = `${id}/${field}`;
  const known = fields.get(key);
  if (known !== undefined) return known;
  const found = of.filter((place) => place.field === field).map(({ error }) => error);
  fields.set(key, found);
  return found;
}

export const useFieldErrors = (id: string, field: string): readonly ServerError[] => useEditing(({ session }) => errorsAt(session, id, field));
