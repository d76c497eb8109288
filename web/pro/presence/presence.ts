// Who is at the document that this page edits, and what the person here does, which others are told.
import type { PointerPlace, TextPlace } from "../../generated/messages";
import { activityOf } from "../../shared/presence/activity";
import { applyPeople, nobody, peopleEvent, presenceChannel, type People, type PeopleEvent } from "../../shared/presence/people";
import { openPace, type Pace } from "../../shared/presence/pace";
import { listenToStream, session, view } from "../client";
import { editedTree, editing } from "../edit/editing";
import { createStore, useSelected } from "../../page/store";
import { listenToOwnName, ownName } from "./ownName";

export const people = createStore<People, PeopleEvent>(nobody, applyPeople);
export const usePeople = <T>(select: (people: People) => T): T => useSelected(people, select);

const text = createStore<TextPlace | undefined, TextPlace | undefined>(undefined, (_, at) => at);
const pointer = createStore<PointerPlace | undefined, PointerPlace | undefined>(undefined, (_, at) => at);

/** Where the person here writes; nothing: nowhere. */
export const writeAt = (at: TextPlace | undefined): void => text.dispatch(at);
/** The person here has left this field. */
export function stopWriting(element: string, field: string): void {
  const now = text.get();
  if (now !== undefined && (now.element ?? "") === element && now.field === field) text.dispatch(undefined);
}
/** Where their pointer is on the drawing; nothing: elsewhere. */
export const pointAt = (at: PointerPlace | undefined): void => pointer.dispatch(at);

const current = () => activityOf({ name: ownName(), tree: editedTree(), view: view.get(), text: text.get(), pointer: pointer.get() });

interface Open {
  readonly document: string;
  readonly end: () => void;
}
let open: Open | undefined;

function join(document: string): Open {
  const connected = session.get().connection === "open";
  people.dispatch({ type: "open", document, connected });
  const isSeen = () => !globalThis.document.hidden;
  let pace: Pace | undefined = undefined;
  const { stream, end } = listenToStream({
    update: (update) => {
      const event = peopleEvent(document, update);
      if (event !== undefined) people.dispatch(event);
    },
    connection: (now) => {
      people.dispatch({ type: "connection", connected: now === "open" });
      if (now === "open") pace?.renew();
    },
  });
  stream.subscribe(presenceChannel(document));
  const opened = openPace(current, (activity) => stream.send({ type: "presence", document, ...activity }), isSeen);
  pace = opened;
  opened.renew();
  const ends = [text.listen, pointer.listen, view.listen, editing.listen, listenToOwnName].map((listen) => listen(opened.changed));
  // A page that is not seen sends nothing: its person counts as gone after a while.
  const seen = () => isSeen() && opened.renew();
  globalThis.document.addEventListener("visibilitychange", seen);
  return {
    document,
    end: () => {
      globalThis.document.removeEventListener("visibilitychange", seen);
      [...ends, end].forEach((stop) => stop());
      opened.close();
      stream.unsubscribe(presenceChannel(document));
      people.dispatch({ type: "open", document: undefined, connected: false });
    },
  };
}

/** Follows the document that is edited: the person here is at it, and at no other. To be called once. */
export function followDocument(): void {
  const follow = () => {
    const { document } = editing.get();
    if (document === open?.document) return;
    open?.end();
    open = document === undefined ? undefined : join(document);
  };
  editing.listen(follow);
  follow();
}
