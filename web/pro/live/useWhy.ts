// The answer of the server why something is as it is in the watched run, asked for again when the run has gone on.
import { useEffect, useEffectEvent, useRef, useState } from "react";
import type { Why } from "../../generated/messages";
import type { MicroStep } from "../../shared/derivation/proof";
import { messageOf } from "../../shared/messageOf";
import { subjectQuery, type Subject } from "../../shared/run/subject";
import { api, sourceOf, useCore, useSession } from "../client";

/** An explanation of the server, or its error. */
export type Answer = { readonly why: Why } | { readonly failed: string };

/** The server is asked at most this often [ms]. */
const kEvery = 250;

/**
 * Asked again when `moment` or `before` changes; the previous answer stays until the next one arrives. Nothing: it is not here yet, or nothing is
 * asked about. `before`: of a past micro step, as GET .../why.
 */
export function useWhy(subject: Subject | undefined, moment: unknown, before?: MicroStep): Answer | undefined {
  const id = useCore()?.id;
  const source = useSession(sourceOf);
  const key = id === undefined || subject === undefined ? undefined : `${source} ${id} ${subjectQuery(subject)}`;
  const [answer, setAnswer] = useState<{ readonly of: string; readonly number: number; readonly answer: Answer }>();
  const askedRef = useRef({ at: 0, of: "", number: 0 });
  const ask = useEffectEvent(() => {
    if (id === undefined || subject === undefined || key === undefined) return;
    const number = askedRef.current.number + 1;
    askedRef.current = { at: performance.now(), of: key, number };
    // An earlier question may be answered later.
    const take = (now: Answer) => setAnswer((known) => (known !== undefined && known.number > number ? known : { of: key, number, answer: now }));
    api.why(source, id, subject, before).then((why) => take({ why }), (error: unknown) => take({ failed: messageOf(error) }));
  });
  const [step, micro] = [before?.step, before?.micro];
  useEffect(() => {
    if (key === undefined) return;
    const { at, of } = askedRef.current;
    const timer = setTimeout(ask, of === key ? Math.max(0, at + kEvery - performance.now()) : 0);
    return () => clearTimeout(timer);
  }, [key, moment, step, micro]);
  return answer !== undefined && answer.of === key ? answer.answer : undefined;
}
