// The times of the macro steps that the time line shows; of a run that goes on they come anew with its steps.
import { useEffect, useState } from "react";
import { messageOf } from "../../shared/messageOf";
import { timesOf, type Times } from "../../shared/runs/times";
import { api } from "../client";

interface Known {
  readonly id: string;
  readonly times?: Times;
  readonly failed?: string;
}

/** Those of macro steps `first` to `last` of run `id`; nothing before they are here. */
export function useTimes(id: string, first: number, last: number): Omit<Known, "id"> {
  const [known, setKnown] = useState<Known>();
  useEffect(() => {
    let current = true;
    api.timing(id, first, last).then(
      (timing) => current && setKnown({ id, times: timesOf(timing) }),
      (error: unknown) => current && setKnown((before) => ({ ...(before?.id === id && before), id, failed: messageOf(error) })),
    );
    return () => {
      current = false;
    };
  }, [id, first, last]);
  return known?.id === id ? known : {};
}
