// Answers the question of a display from the expert page, which is a display for as long as that takes.
import { openStream, type Stream } from "../../shared/stream";
import { ownStream } from "../client";
import { giving } from "../../shared/display/giving";
import { ownDisplayFor, placeOf } from "../../shared/run/displayCalls";
import type { PersonWait } from "../../shared/run/waitingForPerson";

/** [ms] */
const kMostTime = 5000;

/** Gives this answer, if the question is still the one that was seen. Throws what is in the way. */
export function giveAnswer({ question, display }: Pick<PersonWait, "question" | "display">, answer: string | number): Promise<void> {
  let stream: Stream | undefined;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let sent: number | undefined;
  const given = new Promise<void>((resolve, reject) => {
    timer = setTimeout(() => reject(new Error("the server has not taken the answer")), kMostTime);
    stream = openStream(ownStream, {
      onConnection: () => undefined,
      onMalformed: reject,
      onUpdate: (update) => {
        if (update.type === "refused") reject(new Error(update.errors.map(({ message }) => message).join("; ")));
        if (update.type !== "display") return;
        const asked = update.content.question;
        switch (giving(asked, question, sent)) {
          case "send":
            if (asked !== undefined && stream?.send({ type: "answer", question: asked.id, answer }) === true) sent = asked.id;
            return;
          case "given":
            resolve();
            return;
          case "gone":
            reject(new Error("the question is not asked any more"));
            return;
          case "wait":
        }
      },
    });
    stream.announceDisplay(ownDisplayFor(display), false, placeOf(display));
  });
  return given.finally(() => {
    clearTimeout(timer);
    stream?.close();
  });
}
