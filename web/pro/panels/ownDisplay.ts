// This page as a display, once a person wants that: what a task shows is shown by its bars, and a question is answered there.
import { openStream, type Stream } from "../../shared/stream";
import { ownDisplayFor, placeOf } from "../../shared/run/displayCalls";
import { ownStream, problem } from "../client";
import { createStore, useSelected } from "../../page/store";

/** The names of the displays that this page is. */
const names = createStore<readonly string[], readonly string[]>([], (_, next) => next);
export const useOwnDisplays = (): readonly string[] => useSelected(names, (all) => all);

const streams = new Map<string, Stream>();

/** Makes the page the display that shows what this one does (displayCalls.ts) until it is closed, or says that it is none any more. */
export function becomeDisplay(display: string): void {
  const name = ownDisplayFor(display);
  const place = placeOf(display);
  const known = streams.get(name);
  if (known !== undefined) {
    known.announceDisplay(name, false, place);
    return;
  }
  const stream = openStream(ownStream, {
    onConnection: () => undefined,
    onMalformed: problem,
    onUpdate: (update) => {
      if (update.type !== "refused") return;
      endDisplay(name);
      problem(`The page is no display: ${update.errors.map(({ message }) => message).join("; ")}`);
    },
  });
  stream.announceDisplay(name, false, place);
  streams.set(name, stream);
  names.dispatch([...streams.keys()]);
}

export function endDisplay(name: string): void {
  streams.get(name)?.close();
  streams.delete(name);
  names.dispatch([...streams.keys()]);
}
