// Takes the controls, asks for them if somebody has them, or gives them back.
import { useEffect, useState } from "react";
import { kAnswerTime, leftToAnswer } from "../shared/control/texts";
import { useStop } from "../stop/useStop";
import { controls, useControls } from "./page";

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
      <button type="button" className="control-give" title="What you moved by hand stops, and runs that need you are paused" onClick={() => controls.release()}>
        Give back
      </button>
    );
  if (kind === "asked") return <Waiting />;
  const why = refusal ?? (!isFree && isAsked ? "somebody else asks for them already" : undefined);
  return (
    <button type="button" className="control-take" disabled={kind === "taking" || why !== undefined} title={why ?? (isFree ? "Then nobody else moves the cell or begins a run" : "A person at the cell has to allow it")} onClick={() => controls.take(address, !isFree)}>
      {kind === "taking" ? "Taking…" : isFree ? "Take the controls" : "Ask to take over"}
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
      <span role="status">A person at the cell is asked</span>
      <span className="control-left">{left} s</span>
      <button type="button" className="control-give" onClick={() => controls.release()}>
        Ask no more
      </button>
    </>
  );
}
