// Somebody asks for the controls that another one has: a person at the cell allows it, or not.
import { useState } from "react";
import type { Control } from "../generated/messages";
import { answerRequest, ControlRefusal } from "../shared/control/requests";
import { messageOf } from "../shared/messageOf";
import { useStop } from "../stop/useStop";
import { useLeft } from "./TakeButton";

interface Props {
  readonly request: NonNullable<Control["request"]>;
  /** Why this person does not answer. */
  readonly refusal: string | undefined;
  /** Of the account. */
  readonly fetcher: typeof fetch;
}

export function RequestBar({ request: { id, by }, refusal, fetcher }: Props) {
  const left = useLeft();
  const loser = useStop((stop) => (stop.holder === null ? "nobody" : stop.holder.number === stop.held ? "you" : stop.holder.by));
  const [busy, setBusy] = useState(false);
  const [reason, setReason] = useState<string>();
  const [isOver, setOver] = useState(false);
  const answer = async (allow: boolean) => {
    setBusy(true);
    setReason(undefined);
    try {
      await answerRequest(fetcher, id, allow);
    } catch (error) {
      setReason(messageOf(error));
      setOver(error instanceof ControlRefusal && error.status < 500);
      setBusy(false);
    }
  };
  const why = refusal ?? (isOver ? reason : undefined);
  return (
    <div className="control-request" role="group" aria-label="Request for the controls">
      <p role="alert">
        <strong>{by} asks for the controls.</strong> <span>{loser === "you" ? "You lose them" : `${loser} loses them`} if this is allowed, and what moves by them stops.</span>
      </p>
      <span className="control-left">{left} s</span>
      <div>
        <button type="button" disabled={busy || why !== undefined} title={why} onClick={() => void answer(true)}>
          Allow
        </button>
        <button type="button" disabled={busy || why !== undefined} title={why} onClick={() => void answer(false)}>
          Refuse
        </button>
        {(why ?? reason) !== undefined && <small role="status">Not here: {why ?? reason}.</small>}
      </div>
    </div>
  );
}
