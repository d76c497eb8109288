// Who is at the document that this page edits, as a value, and what a message of the stream makes of it.
import { assertNever } from "../assertNever";
import type { PersonAt, PresenceDelta, PresenceSnapshot, ServerError } from "../../generated/messages";
import type { StreamUpdate } from "../messages/stream";

export interface People {
  /** The name of the document; nothing: none is open. */
  readonly document: string | undefined;
  readonly there: ReadonlyMap<number, PersonAt>;
  /** Ids of the person at this page: the present one last. Earlier ones may be shown for a while after a connection was lost. */
  readonly own: readonly number[];
  /** The connection is open, so what is known of others holds. */
  readonly connected: boolean;
  /** So many are there that others do not see the person at this page. */
  readonly full: boolean;
}

export type PeopleEvent =
  | { readonly type: "open"; readonly document: string | undefined; readonly connected: boolean }
  | { readonly type: "connection"; readonly connected: boolean }
  | { readonly type: "snapshot"; readonly data: PresenceSnapshot }
  | { readonly type: "delta"; readonly data: PresenceDelta }
  | { readonly type: "joined"; readonly id: number }
  | { readonly type: "refused"; readonly errors: readonly ServerError[] };

export const nobody: People = { document: undefined, there: new Map(), own: [], connected: false, full: false };

export const presenceChannel = (document: string): string => `presence/${document}`;

/** What an update of the stream says of the people at the document; nothing: it is about something else. */
export function peopleEvent(document: string, update: StreamUpdate): PeopleEvent | undefined {
  const channel = presenceChannel(document);
  switch (update.type) {
    case "people":
      return update.channel === channel ? { type: "snapshot", data: update.people } : undefined;
    case "people_changed":
      return update.channel === channel ? { type: "delta", data: update.change } : undefined;
    case "joined":
      return update.joined.document === document ? { type: "joined", id: update.joined.id } : undefined;
    case "refused":
      return update.channel === channel ? { type: "refused", errors: update.errors } : undefined;
    default:
      return undefined;
  }
}

function changed(people: People, { people: shown, left }: PresenceDelta): People {
  const there = new Map(people.there);
  for (const person of shown) there.set(person.id, person);
  for (const id of left) there.delete(id);
  return { ...people, there };
}

export function applyPeople(people: People, event: PeopleEvent): People {
  switch (event.type) {
    case "open":
      return { ...nobody, document: event.document, connected: event.connected };
    case "connection":
      return { ...people, connected: event.connected };
    case "snapshot":
      return { ...people, there: new Map(event.data.people.map((person) => [person.id, person])) };
    case "delta":
      return changed(people, event.data);
    case "joined":
      return { ...people, own: [...people.own, event.id], full: false };
    case "refused":
      return event.errors.some(({ code }) => code === "too_large") ? { ...people, full: true } : people;
    default:
      return assertNever(event);
  }
}

/** The others, those who came first first. None until it is known which of all is the person at this page. */
export function othersOf({ there, own, connected, full }: People): readonly PersonAt[] {
  if (!connected || (own.length === 0 && !full)) return [];
  return [...there.values()].filter(({ id }) => !own.includes(id)).sort((a, b) => a.id - b.id);
}

/** The person at this page, as others see them. */
export const selfOf = ({ there, own }: People): PersonAt | undefined => there.get(own.at(-1) ?? 0);
