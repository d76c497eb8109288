// This page as the display `one`: what tasks show and ask is shown and answered on its run view.
import { applyDisplayEvent, canAnswer, firstPage, type DisplayEvent, type DisplayPage } from "../../shared/display/page";
import { createStore, useSelected } from "../../page/store";
import { openStream, streamUrl, type Stream } from "../../shared/stream";
import { access, refusalNow } from "../client";

export const kDisplay = "one";

const store = createStore<DisplayPage, DisplayEvent>(firstPage(kDisplay), applyDisplayEvent);
export const useDisplay = <T>(select: (page: DisplayPage) => T): T => useSelected(store, select);

let stream: Stream | undefined;

/** From now on, until the result is called. A page of who may not answer is no display. */
export function becomeDisplay(): () => void {
  if (refusalNow("be_display") !== undefined) return () => undefined;
  const opened = openStream(() => access.streamUrl(streamUrl(location)), {
    onConnection: (connection) => store.dispatch({ type: "connection", connection }),
    onMalformed: (error) => store.dispatch({ type: "problem", text: error.message }),
    onUpdate: (update) => {
      if (update.type === "display") store.dispatch({ type: "content", content: update.content });
      else if (update.type === "refused") store.dispatch({ type: "problem", text: update.errors.map(({ message }) => message).join("; ") });
    },
  });
  opened.announceDisplay(kDisplay, false);
  stream = opened;
  return () => {
    opened.close();
    if (stream === opened) stream = undefined;
  };
}

export function answer(question: number, value: string | number): void {
  if (canAnswer(store.get()) && stream?.send({ type: "answer", question, answer: value }) === true) store.dispatch({ type: "sent" });
}

export const press = (button: string): void => void stream?.send({ type: "press", button });
