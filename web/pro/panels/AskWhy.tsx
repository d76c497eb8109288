// The server's answers about a port, an action or a parameter: why it is as it is now, and how it came to what it did last.
import { useMemo } from "react";
import { lastInference, microStepText, type MicroStep } from "../../shared/derivation/proof";
import { whenText } from "../../shared/past/moment";
import { stateShown, stepsShown, stepsUntil } from "../../shared/past/shown";
import { inputText } from "../../shared/run/inputText";
import type { Subject } from "../../shared/run/subject";
import { constantText, parameterHeadline, type WhyCondition } from "../../shared/run/whyText";
import { isStored } from "../../shared/session/session";
import { useSession, view } from "../client";
import { useWhy } from "../live/useWhy";
import { Atoms, Reads, WhyView } from "./WhyView";

export function AskWhy({ subject }: { readonly subject: Subject }) {
  const steps = useSession(stepsUntil);
  const last = lastInference(steps, subject);
  const [step, micro] = [last?.step, last?.micro];
  const at = useMemo(() => (step === undefined || micro === undefined ? undefined : { step, micro }), [step, micro]);
  return (
    <>
      <WhyNow subject={subject} known={at !== undefined} />
      {at !== undefined && <WhyThen subject={subject} at={at} />}
    </>
  );
}

/** For the state that is shown; a port that has fired is explained by its firing, if that is known. */
function WhyNow({ subject, known }: { readonly subject: Subject; readonly known: boolean }) {
  const past = useSession((s) => s.past?.past);
  const stored = useSession(isStored);
  const answer = useWhy(subject, useSession(stateShown), past);
  if (answer === undefined) return null;
  if ("failed" in answer) return <p className="quiet">No explanation: {answer.failed}</p>;
  const { why } = answer;
  return "port" in why && why.active && known ? null : <WhyView why={why} when={whenText(past, stored)} />;
}

/** How it came to what it did last, as things were when its turn came, with the way to the derivation. */
function WhyThen({ subject, at }: { readonly subject: Subject; readonly at: MicroStep }) {
  const answer = useWhy(subject, undefined, at);
  const input = useSession((s) => stepsShown(s).find((step) => step.step === at.step)?.input);
  if (answer === undefined || "failed" in answer) return null;
  const { why } = answer;
  const [label, did] = "port" in why ? ["Why it fired", "Fired"] : "reads" in why ? ["Where its value came from", "Resolved"] : ["Why it was executed", "Executed"];
  return (
    <section className="why" aria-label={label}>
      <h3>
        {did} in {microStepText(at)}
      </h3>
      {"reads" in why ? (
        <p>
          {input !== undefined && <>Upon <code>{inputText(input)}</code>. </>}
          {parameterHeadline(why)}.
        </p>
      ) : "port" in why && why.forced === true ? (
        <p>Somebody had forced it, whatever its condition (R24).</p>
      ) : (
        input !== undefined && (
          <p>
            Upon <code>{inputText(input)}</code>, its condition was true:
          </p>
        )
      )}
      {"reads" in why ? why.expression !== undefined && why.argument !== true && <Reads why={why} /> : <ConditionThen why={why} />}
      <button type="button" className="link" onClick={() => view.dispatch({ type: "step", step: at.step, inference: { micro: at.micro, of: subject } })}>
        Show the derivation
      </button>
    </section>
  );
}

function ConditionThen({ why }: { readonly why: WhyCondition }) {
  const constant = constantText(why);
  return (
    <>
      {constant !== undefined && <p>{constant}</p>}
      <Atoms why={why} />
    </>
  );
}
