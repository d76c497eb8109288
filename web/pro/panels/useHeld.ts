// The inputs that have come to a run that is paused, and are held.
import { useEffect, useState } from "react";
import type { Core, Past } from "../../generated/messages";
import { holdsInputs } from "../../shared/run/controls";
import { api, useSession } from "../client";

/** A sampled event takes the place of the one before, which no number tells of [ms]. */
const kPeriod = 1000;

/** `holds`: inputs are held; what they are follows when it is known. */
export function useHeld(core: Core | undefined): { readonly holds: boolean; readonly waiting: Past["waiting"] } {
  const [held, setHeld] = useState<{ readonly id: string; readonly waiting: Past["waiting"] }>();
  const isOpen = useSession((s) => s.connection === "open");
  const holds = isOpen && core !== undefined && holdsInputs(core);
  const [id, step, micro, count] = [core?.id, core?.step, core?.micro, core?.waiting];
  useEffect(() => {
    if (!holds || id === undefined || step === undefined) return;
    let timer: ReturnType<typeof setTimeout> | undefined;
    let current = true;
    const load = async (): Promise<void> => {
      const past = await api.past("cores", id, { step }).catch(() => undefined);
      if (!current) return;
      if (past !== undefined) setHeld({ id, waiting: past.waiting });
      timer = setTimeout(() => void load(), kPeriod);
    };
    void load();
    return () => {
      current = false;
      clearTimeout(timer);
    };
  }, [id, step, micro, count, holds]);
  return { holds, waiting: holds && held?.id === id ? held?.waiting : undefined };
}
