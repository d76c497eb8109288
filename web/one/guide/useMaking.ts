// Something is being made, and what kept it from that.
import { useState } from "react";
import { messageOf } from "../../shared/messageOf";

export interface Making {
  readonly busy: boolean;
  readonly problem: string | undefined;
  readonly make: () => void;
}

export function useMaking(work: () => Promise<unknown>): Making {
  const [busy, setBusy] = useState(false);
  const [problem, setProblem] = useState<string>();
  const make = async () => {
    setBusy(true);
    setProblem(undefined);
    try {
      await work();
    } catch (error) {
      setProblem(messageOf(error));
    }
    setBusy(false);
  };
  return { busy, problem, make: () => void make() };
}
