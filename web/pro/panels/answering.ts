// Answers the question of a display from the expert page, which is a display for as long as that takes.
import { openStream, streamUrl, type Stream } from "../../shared/stream";
import { ownDisplayFor } from "../../shared/run/displayCalls";
import type { PersonWait } from "../../shared/run/waitingForPerson";

/** [ms] */
const kMostTime = 5000;

/** Gives this answer, if the question is still the one that was seen. Throws what is in the way. */
export function giveAnswer({ question, display }: Pick<PersonWait, "question" | "display">, answer: string | number): Promise<void> {
  let stream: Stream | undefined;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let sent = false;
  const given = new Promise<void>((resolve, reject) => {
    timer = setTimeout(() => reject(new Error("the server has not taken the answer")), kMostTime);
    stream = openStream(streamUrl(location), {
      onConnection: () => undefined,
      onMalformed: reject,
      onUpdate: (update) => {
        if (update.type === "refused") reject(new Error(update.errors.map(({ message }) => message).join("; ")));
        if (update.type !== "display") return;
        const asked = update.content.question;
        if (sent && asked?.text !== question) resolve();
        else if (!sent && asked !== undefined && asked.text === question) sent = stream?.send({ type: "answer", question: asked.id, answer }) ?? false;
        else if (!sent) reject(new Error("the question is not asked any more"));
      },
    });
    stream.announceDisplay(ownDisplayFor(display), false);
  });
  return given.finally(() => {
    clearTimeout(timer);
    stream?.close();
  });
}
