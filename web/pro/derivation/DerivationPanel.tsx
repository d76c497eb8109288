// The derivation of every micro step: macro steps to the left, their proof trees in the middle, the selected inference to the right.
import { memo, useEffect, useRef, useState } from "react";
import { leading, nodeAt, size, summary, type ProofPath } from "../../shared/derivation/proof";
import { stepRows } from "../../shared/derivation/stepRows";
import { microCount } from "../../shared/derivation/steps";
import type { Derivation, TraceStep } from "../../generated/messages";
import { stepsShown } from "../../shared/past/shown";
import { callText, inputText } from "../../shared/run/inputText";
import { useSession, useView, view } from "../client";
import { Splitter } from "../layout/Splitter";
import { toPresent, visitStep } from "../past/past";
import { InferenceCard } from "./InferenceCard";
import { ProofTree } from "./ProofTree";

export interface Picked {
  readonly micro: number;
  readonly path: ProofPath;
}

export function DerivationPanel() {
  const steps = useSession(stepsShown);
  const wanted = useView((v) => v.step);
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
}

/** Shows the derivation of a macro step, and the model as it was at its end. */
function show(step: number): void {
  visitStep(step);
  view.dispatch({ type: "step", step });
}

function follow(): void {
  toPresent();
  view.dispatch({ type: "step", step: undefined });
}

interface StepListProps {
  readonly steps: readonly TraceStep[];
  readonly shown: number;
  readonly follows: boolean;
}

function StepList({ steps, shown, follows }: StepListProps) {
  const list = useRef<HTMLOListElement>(null);
  const [filter, setFilter] = useState("");
  const [opened, setOpened] = useState<ReadonlySet<number>>(new Set());
  const rows = stepRows(steps, filter, shown, opened);
  useEffect(() => {
    list.current?.querySelector("[aria-current]")?.scrollIntoView({ block: "nearest" });
  }, [shown, steps]);
  return (
    <div className="step-list">
      <label className="check">
        <input type="checkbox" checked={follows} onChange={(event) => (event.target.checked ? follow() : view.dispatch({ type: "step", step: shown }))} />
        Follow the run
      </label>
      <input type="search" placeholder="Filter" aria-label="Filter the macro steps" value={filter} onChange={(event) => setFilter(event.target.value)} />
      {rows.length === 0 && <p className="quiet pad">No macro step has that in its input or calls.</p>}
      <ol ref={list} aria-label="Macro steps">
        {rows.map((row) =>
          row.kind === "step" ? (
            <StepRow key={row.step.step} step={row.step} isShown={row.step.step === shown} />
          ) : (
            <li key={`idle ${row.first}`}>
              <button type="button" className="step-idle" aria-expanded={false} onClick={() => setOpened(new Set([...opened, row.first]))}>
                <b>▸</b>
                <span>
                  {row.count} steps that changed nothing
                </span>
                <small>
                  {row.first} to {row.last}
                </small>
              </button>
            </li>
          ),
        )}
      </ol>
    </div>
  );
}

const StepRow = memo(function StepRow({ step, isShown }: { readonly step: TraceStep; readonly isShown: boolean }) {
  return (
    <li>
      <button type="button" aria-current={isShown ? "step" : undefined} onClick={() => show(step.step)}>
        <b>{step.step}</b>
        <span>{inputText(step.input)}</span>
        <small>
          {microCount(step)} micro{step.complete === false ? " …" : ""}
        </small>
      </button>
    </li>
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
