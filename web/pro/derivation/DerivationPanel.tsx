// The derivation of every micro step: macro steps to the left, their proof trees in the middle, the selected inference to the right.
import { memo, useState } from "react";
import { leading, nodeAt, size, summary, type ProofPath } from "../../shared/derivation/proof";
import type { Derivation, TraceStep } from "../../generated/messages";
import { stepsShown } from "../../shared/past/shown";
import { callText } from "../../shared/run/inputText";
import { useSession, useView } from "../client";
import { Splitter } from "../layout/Splitter";
import { InferenceCard } from "./InferenceCard";
import { ProofTree } from "./ProofTree";
import { StepList } from "./StepList";
import { useSlowly } from "./useSlowly";

export interface Picked {
  readonly micro: number;
  readonly path: ProofPath;
}

/** Steps that come faster are shown together [ms]: nobody reads more, and drawing them would slow the page down. */
const kPace = 250;

export function DerivationPanel() {
  const steps = useSlowly(useSession(stepsShown), kPace);
  const wanted = useView((v) => v.step);
  return <Steps steps={steps} wanted={wanted} />;
}

const Steps = memo(function Steps({ steps, wanted }: { readonly steps: readonly TraceStep[]; readonly wanted: number | undefined }) {
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
      <StepProofs key={shown.step} step={shown} />
    </section>
  );
});

interface ProofProps {
  readonly micro: Derivation;
  readonly number: number;
  readonly picked: ProofPath | undefined;
  readonly onPick: (path: ProofPath) => void;
}

function Proof({ micro, number, picked, onPick }: ProofProps) {
  const [unfolded, setUnfolded] = useState(false);
  return (
    <article className="proof" aria-label={`Micro step ${number}`}>
      <header>
        <h3>Micro step {number}</h3>
        <span>{summary(micro)}</span>
        <button type="button" className="link" onClick={() => setUnfolded(!unfolded)}>
          {unfolded ? "Fold" : "Unfold all"}
        </button>
        <small>{size(micro)} nodes</small>
      </header>
      <ProofTree key={String(unfolded)} root={micro} micro={number} picked={picked} onPick={onPick} unfolded={unfolded} />
    </article>
  );
}

function firstPick(step: TraceStep): Picked {
  const root = step.micro[0];
  return { micro: 0, path: root === undefined ? [] : leading(root) };
}

function StepProofs({ step }: { readonly step: TraceStep }) {
  const [picked, setPicked] = useState<Picked>(() => firstPick(step));
  const root = step.micro[picked.micro];
  const node = root === undefined ? undefined : nodeAt(root, picked.path);
  return (
    <>
      <div className="proofs">
        {step.micro.length === 0 && <p className="quiet pad">Nothing changed: this macro step has no micro step that is not idle.</p>}
        {step.micro.map((micro, i) => (
          <Proof
            key={i}
            micro={micro}
            number={(step.first ?? 0) + i}
            picked={picked.micro === i ? picked.path : undefined}
            onPick={(path) => setPicked({ micro: i, path })}
          />
        ))}
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
