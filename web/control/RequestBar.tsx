// Somebody asks for the controls that another one has: a person at the cell allows it, or not.
import { useState } from "react";
import type { Control } from "../generated/messages";
import { isRefusal } from "../shared/api";
import { answerRequest } from "../shared/control/requests";
import { messageOf } from "../shared/messageOf";
import { useStop } from "../stop/useStop";
import { useLeft } from "./TakeButton";
import { texts } from "./texts";

interface Props {
  readonly request: NonNullable<Control["request"]>;
  /** Why this person does not answer. */
  readonly refusal: string | undefined;
  /** Of the account. */
  readonly fetcher: typeof fetch;
}

export function RequestBar({ request: { id, by }, refusal, fetcher }: Props) {
  const left = useLeft();
  /** Nothing: the person at this page. */
  const loser = useStop((stop) => (stop.holder === null ? texts.request.nobody : stop.holder.number === stop.held ? undefined : stop.holder.by));
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
      setOver(isRefusal(error) && error.status < 500);
      setBusy(false);
    }
  };
  const why = refusal ?? (isOver ? reason : undefined);
  const said = why ?? reason;
  return (
    <div className="control-request" role="group" aria-label={texts.request.name}>
      <p role="alert">
        <strong>{texts.request.asks(by)}</strong> <span>{loser === undefined ? texts.request.youLose : texts.request.loses(loser)}</span>
      </p>
      <span className="control-left">{texts.take.seconds(left)}</span>
      <div>
        <button type="button" disabled={busy || why !== undefined} title={why} onClick={() => void answer(true)}>
          {texts.request.allow}
        </button>
        <button type="button" disabled={busy || why !== undefined} title={why} onClick={() => void answer(false)}>
          {texts.request.refuse}
        </button>
        {said !== undefined && <small role="status">{texts.request.refused(said)}</small>}
      </div>
    </div>
  );
}
