// The server's answers for a selected port: why it does not fire now, and why it fired when it last did.
import { useEffect, useMemo, useState } from "react";
import { lastFiring, type MicroStep } from "../../shared/derivation/proof";
import type { Why } from "../../generated/messages";
import { whenText } from "../../shared/past/moment";
import { stateShown, stepsShown, stepsUntil } from "../../shared/past/shown";
import { inputText } from "../../shared/run/inputText";
import { constantText } from "../../shared/run/whyText";
import { isStored } from "../../shared/session/session";
import { api, sourceOf, useCore, useSession, view } from "../client";
import { Atoms, WhyView } from "./WhyView";
import { messageOf } from "../../shared/messageOf";

/** An explanation of the server, or its error. */
type Answer = { readonly why: Why } | { readonly failed: string } | undefined;

/** Asks again when `moment` changes; the previous answer stays until the next one arrives. */
function useWhy(address: string, moment: unknown, before?: MicroStep): Answer {
  const id = useCore()?.id;
  const source = useSession(sourceOf);
  const [answer, setAnswer] = useState<Answer>();
  useEffect(() => {
    if (id === undefined) return;
    let current = true;
    api.why(source, id, address, before).then(
      (why) => current && setAnswer({ why }),
      (error: unknown) => current && setAnswer({ failed: messageOf(error) }),
    );
    return () => {
      current = false;
    };
  }, [id, source, address, moment, before]);
  return answer;
}

export function AskWhy({ address }: { readonly address: string }) {
  const steps = useSession(stepsUntil);
  const fired = lastFiring(steps, address);
  const [step, micro] = [fired?.step, fired?.micro];
  const firing = useMemo(() => (step === undefined || micro === undefined ? undefined : { step, micro }), [step, micro]);
  return (
    <>
      <WhyNow address={address} known={firing !== undefined} />
      {firing !== undefined && <WhyFired address={address} firing={firing} />}
    </>
  );
}

/** For the state that is shown; a port that has fired is explained by its firing, if that is known. */
function WhyNow({ address, known }: { readonly address: string; readonly known: boolean }) {
  const past = useSession((s) => s.past?.past);
  const stored = useSession(isStored);
  const answer = useWhy(address, useSession(stateShown), past);
  if (answer === undefined) return null;
  if ("failed" in answer) return <p className="quiet">No explanation: {answer.failed}</p>;
  return answer.why.active && known ? null : <WhyView why={answer.why} when={whenText(past, stored)} />;
}

/** The atoms of its condition as they were when it fired, with the way to the derivation. */
function WhyFired({ address, firing }: { readonly address: string; readonly firing: MicroStep }) {
  const answer = useWhy(address, undefined, firing);
  const input = useSession((s) => stepsShown(s).find((step) => step.step === firing.step)?.input);
  if (answer === undefined || "failed" in answer) return null;
  const constant = constantText(answer.why);
  return (
    <section className="why" aria-label="Why it fired">
      <h3>
        Fired in macro step {firing.step}, micro step {firing.micro}
      </h3>
      {input !== undefined && (
        <p>
          Upon <code>{inputText(input)}</code>, its condition was true:
        </p>
      )}
      {constant !== undefined && <p>{constant}</p>}
      <Atoms why={answer.why} />
      <button type="button" className="link" onClick={() => view.dispatch({ type: "step", step: firing.step })}>
        Show the derivation
      </button>
    </section>
  );
}
