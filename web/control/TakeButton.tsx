// Takes the controls, asks for them if somebody has them, or gives them back.
import { useEffect, useState } from "react";
import { kAnswerTime, leftToAnswer } from "../shared/control/texts";
import { useStop } from "../stop/useStop";
import { controls, useControls } from "./page";
import { texts } from "./texts";

export interface TakeProps {
  /** Of the connection that holds them. */
  readonly address: () => Promise<string>;
  /** Why this person does not get them. */
  readonly refusal: string | undefined;
}

export function TakeButton({ address, refusal }: TakeProps) {
  const kind = useControls((state) => state.kind);
  const isFree = useStop((stop) => stop.holder === null);
  const isAsked = useStop((stop) => stop.request !== null);
  if (kind === "held")
    return (
      <button type="button" className="control-give" title={texts.take.giveBackTitle} onClick={() => controls.release()}>
        {texts.take.giveBack}
      </button>
    );
  if (kind === "asked") return <Waiting />;
  const why = refusal ?? (!isFree && isAsked ? texts.take.othersAsk : undefined);
  return (
    <button type="button" className="control-take" disabled={kind === "taking" || why !== undefined} title={why ?? (isFree ? texts.take.takeTitle : texts.take.askTitle)} onClick={() => controls.take(address, !isFree)}>
      {kind === "taking" ? texts.take.taking : isFree ? texts.take.take : texts.take.ask}
    </button>
  );
}

/** What is left of the time to answer [s], from now on. */
export function useLeft(): number {
  const [left, setLeft] = useState(kAnswerTime);
  useEffect(() => {
    const since = Date.now();
    const timer = setInterval(() => setLeft(leftToAnswer(since, Date.now())), 500);
    return () => clearInterval(timer);
  }, []);
  return left;
}

function Waiting() {
  const left = useLeft();
  return (
    <>
      <span role="status">{texts.take.asked}</span>
      <span className="control-left">{texts.take.seconds(left)}</span>
      <button type="button" className="control-give" onClick={() => controls.release()}>
        {texts.take.askNoMore}
      </button>
    </>
  );
}
