// A step is tried again once the run that asks what is to be done goes on.
import { useEffect, useRef, useState } from "react";
import type { Core } from "../../generated/messages";
import { canAnswer } from "../../shared/display/page";
import { asksAbout, kRetry } from "../../shared/timeline/teachable";
import { answer, useDisplay } from "./display";

/** `title`: of the step that has failed; nothing: none has. The result answers, now or as soon as this page is asked. */
export function useRetry(core: Core | undefined, title: string | undefined): () => void {
  // How often it was wanted, and how often that was done or has become pointless.
  const [wanted, setWanted] = useState(0);
  const done = useRef(0);
  const question = useDisplay((page) => page.content?.question);
  const may = useDisplay(canAnswer);
  const isGoing = core?.status === "running" && !core.paused;
  const isFailing = title !== undefined;
  useEffect(() => {
    if (done.current === wanted) return;
    if (!isFailing) done.current = wanted;
    else if (isGoing && may && question !== undefined && asksAbout(question, title)) {
      answer(question.id, kRetry);
      done.current = wanted;
    }
  }, [wanted, isGoing, isFailing, may, question, title]);
  return () => setWanted((count) => count + 1);
}
