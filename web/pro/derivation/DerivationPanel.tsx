// The derivation of every micro step: macro steps to the left, their proof trees in the middle, the selected inference to the right.
import { memo, useState } from "react";
import { inferenceOf, leading, nodeAt } from "../../shared/derivation/proof";
import type { TraceStep } from "../../generated/messages";
import { stepsShown } from "../../shared/past/shown";
import { callText } from "../../shared/run/inputText";
import type { WantedInference } from "../../shared/session/view";
import { useSession, useView } from "../client";
import { Splitter } from "../layout/Splitter";
import { InferenceCard } from "./InferenceCard";
import { ProofList, type Foldings, type Picked } from "./ProofList";
import { StepList } from "./StepList";
import { useSlowly } from "./useSlowly";

/** Steps that come faster are shown together [ms]: nobody reads more, and drawing them would slow the page down. */
const kPace = 250;

export function DerivationPanel() {
  const steps = useSlowly(useSession(stepsShown), kPace);
  const wanted = useView((v) => v.step);
  const inference = useView((v) => v.inference);
  return <Steps steps={steps} wanted={wanted} inference={inference} />;
}

interface StepsProps {
  readonly steps: readonly TraceStep[];
  readonly wanted: number | undefined;
  readonly inference: WantedInference | undefined;
}

const Steps = memo(function Steps({ steps, wanted, inference }: StepsProps) {
  const shown = steps.find((step) => step.step === wanted) ?? steps.at(-1);
  if (shown === undefined) {
    return (
      <section className="derivation" aria-label="Derivation">
        <p className="quiet pad">The derivation of each macro step appears here as soon as the run makes one.</p>
      </section>
    );
  }
  return (
    <section className="derivation" aria-label="Derivation">
      <StepList steps={steps} shown={shown.step} follows={wanted === undefined} />
      <Splitter panel="steps" at="right" />
      <StepProofs step={shown} wanted={shown.step === wanted ? inference : undefined} />
    </section>
  );
});

/** What a reader does with a macro step: forgotten with the next one that is shown, and when something of it is asked for. */
interface Reading {
  readonly step: number;
  readonly wanted: WantedInference | undefined;
  readonly picked: Picked;
  readonly foldings: Foldings;
}

/** At first that inference is picked at which something happens in the first micro step, or in the one that is wanted: there, that of what is asked about. */
function begin({ step, micro: proofs, first = 0 }: TraceStep, wanted: WantedInference | undefined): Reading {
  const micro = Math.max(0, (wanted?.micro ?? 0) - first);
  const root = proofs[micro];
  const asked = root === undefined || wanted?.of === undefined ? undefined : inferenceOf(root, wanted.of);
  return { step, wanted, picked: { micro, path: asked ?? (root === undefined ? [] : leading(root)) }, foldings: new Map() };
}

function StepProofs({ step, wanted }: { readonly step: TraceStep; readonly wanted: WantedInference | undefined }) {
  // Not a key of React's: a fast run would make all rows anew four times a second.
  const [kept, setReading] = useState(() => begin(step, wanted));
  const reading = kept.step === step.step && kept.wanted === wanted ? kept : begin(step, wanted);
  const { picked, foldings } = reading;
  const root = step.micro[picked.micro];
  const node = root === undefined ? undefined : nodeAt(root, picked.path);
  return (
    <>
      <div className="proofs">
        {step.micro.length === 0 ? <p className="quiet pad">Nothing changed: this macro step has no micro step that is not idle.</p> : <ProofList step={step} picked={picked} wanted={wanted} foldings={foldings} onPick={(next) => setReading({ ...reading, picked: next })} onFold={(next) => setReading({ ...reading, foldings: next })} />}
        {step.calls.length > 0 && (
          <p className="calls">
            {step.calls.map((call, i) => (
              <code key={i}>{callText(call)}</code>
            ))}
          </p>
        )}
      </div>
      {node !== undefined && (
        <>
          <Splitter panel="inference" at="left" />
          <InferenceCard node={node} />
        </>
      )}
    </>
  );
}
