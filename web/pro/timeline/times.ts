// The times of the macro steps that the time line shows; of a run that goes on they come anew with its steps.
import { useEffect, useState } from "react";
import { messageOf } from "../../shared/messageOf";
import { oneAtATime } from "../../shared/oneAtATime";
import { timesOf, type Times } from "../../shared/runs/times";
import { api } from "../client";

interface Known {
  readonly id: string;
  readonly times?: Times;
  readonly failed?: string;
}

interface Wanted {
  readonly id: string;
  readonly first: number;
  readonly last: number;
}

/** Those of macro steps `first` to `last` of run `id`; nothing before they are here. */
export function useTimes(id: string, first: number, last: number): Omit<Known, "id"> {
  const [known, setKnown] = useState<Known>();
  // A run may go on faster than the server answers.
  const [want] = useState(() =>
    oneAtATime(({ id: of, first: from, last: to }: Wanted) =>
      api.timing(of, from, to).then(
        (timing) => setKnown({ id: of, times: timesOf(timing) }),
        (error: unknown) => setKnown((before) => ({ ...(before?.id === of && before), id: of, failed: messageOf(error) })),
      ),
    ),
  );
  useEffect(() => {
    want({ id, first, last });
    return () => want(undefined);
  }, [want, id, first, last]);
  return known?.id === id ? known : {};
}
