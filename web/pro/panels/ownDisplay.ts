// This page as a display, once a person wants that: what a task shows is shown by its bars, and a question is answered there.
import { openStream, type Stream } from "../../shared/stream";
import { ownStream, problem } from "../client";
import { createStore, useSelected } from "../../page/store";

/** The names of the displays that this page is. */
const names = createStore<readonly string[], readonly string[]>([], (_, next) => next);
export const useOwnDisplays = (): readonly string[] => useSelected(names, (all) => all);

const streams = new Map<string, Stream>();

/** Makes the page this display until it is closed, or says that it is none any more. */
export function becomeDisplay(name: string): void {
  if (streams.has(name)) return;
  const stream = openStream(ownStream, {
    onConnection: () => undefined,
    onMalformed: problem,
    onUpdate: (update) => {
      if (update.type !== "refused") return;
      endDisplay(name);
      problem(`The page is no display: ${update.errors.map(({ message }) => message).join("; ")}`);
    },
  });
  stream.announceDisplay(name, false);
  streams.set(name, stream);
  names.dispatch([...streams.keys()]);
}

export function endDisplay(name: string): void {
  streams.get(name)?.close();
  streams.delete(name);
  names.dispatch([...streams.keys()]);
}
