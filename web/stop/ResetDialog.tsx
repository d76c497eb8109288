// Asks once before the stop is reset.
import { useEffect, useRef, useState } from "react";
import { messageOf } from "../shared/messageOf";
import { kResetQuestion } from "../shared/stop/texts";
import { stop } from "./page";
import { texts } from "./texts";

const t = texts.reset;

interface Props {
  /** Of the account. */
  readonly fetcher: typeof fetch;
  readonly onClose: () => void;
}

export function ResetDialog({ fetcher, onClose }: Props) {
  const dialog = useRef<HTMLDialogElement>(null);
  const keep = useRef<HTMLButtonElement>(null);
  const [busy, setBusy] = useState(false);
  const [reason, setReason] = useState<string>();
  useEffect(() => {
    dialog.current?.showModal();
    keep.current?.focus();
  }, []);
  const reset = async () => {
    setBusy(true);
    setReason(undefined);
    try {
      await stop.reset(fetcher);
      onClose();
    } catch (error) {
      setReason(messageOf(error));
      setBusy(false);
    }
  };
  return (
    <dialog ref={dialog} className="reset-stop" aria-labelledby="reset-stop-title" aria-describedby="reset-stop-question" onClose={onClose} onKeyDown={(event) => event.stopPropagation()}>
      <h2 id="reset-stop-title">{t.title}</h2>
      <p id="reset-stop-question">{kResetQuestion}</p>
      {reason !== undefined && <p role="alert">{t.failed(reason)}</p>}
      <div>
        <button type="button" ref={keep} onClick={() => dialog.current?.close()}>
          {t.keep}
        </button>
        <button type="button" disabled={busy} onClick={() => void reset()}>
          {busy ? t.busy : t.reset}
        </button>
      </div>
    </dialog>
  );
}
