// How long a run that is over was under way.
import { useEffect, useState } from "react";
import { underWay } from "../../shared/runs/texts";
import { api } from "../client";

async function load(id: string): Promise<string | undefined> {
  const [run, timing] = await Promise.all([api.storedRun(id), api.timing(id, 1, 1)]);
  return underWay(run, timing);
}

/** Of run `id`; nothing before it is known, or without a run. */
export function useDuration(id: string | undefined): string | undefined {
  const [known, setKnown] = useState<{ readonly id: string; readonly text: string | undefined }>();
  useEffect(() => {
    if (id === undefined) return undefined;
    let current = true;
    load(id).then(
      (text) => current && setKnown({ id, text }),
      // Without it the card still says how the run ended.
      () => undefined,
    );
    return () => {
      current = false;
    };
  }, [id]);
  return known?.id === id ? known?.text : undefined;
}
