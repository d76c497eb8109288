// An action that the server may refuse.
import { useState } from "react";
import { messageOf } from "../../shared/messageOf";

interface Attempt {
  /** Does it, and keeps why it has failed. */
  readonly attempt: (action: () => Promise<void>) => Promise<void>;
  readonly reason: string | undefined;
  readonly busy: boolean;
}

export function useAttempt(): Attempt {
  const [reason, setReason] = useState<string>();
  const [busy, setBusy] = useState(false);
  const attempt = async (action: () => Promise<void>) => {
    setReason(undefined);
    setBusy(true);
    try {
      await action();
    } catch (error) {
      setReason(messageOf(error));
    } finally {
      setBusy(false);
    }
  };
  return { attempt, reason, busy };
}
