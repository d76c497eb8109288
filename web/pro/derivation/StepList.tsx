// The macro steps of a run, to pick one: of a long list, the rows in view.
import { memo, useEffect, useRef, useState } from "react";
import { stepRows, type StepRow } from "../../shared/derivation/stepRows";
import { microCount } from "../../shared/derivation/steps";
import type { TraceStep } from "../../generated/messages";
import { inputText } from "../../shared/run/inputText";
import { view } from "../client";
import { showRow } from "../panels/showRow";
import { useRowsInView } from "../panels/useRowsInView";
import { toPresent, visitStep } from "../past/past";

/** Height of a row [px]. */
const kRow = 26;
/** Lists up to this length are drawn whole. */
const kWhole = 24;

/** Shows the derivation of a macro step, and the model as it was at its end. */
function show(step: number): void {
  visitStep(step);
  view.dispatch({ type: "step", step });
}

function follow(): void {
  toPresent();
  view.dispatch({ type: "step", step: undefined });
}

interface Props {
  readonly steps: readonly TraceStep[];
  readonly shown: number;
  readonly follows: boolean;
}

export function StepList({ steps, shown, follows }: Props) {
  const [filter, setFilter] = useState("");
  const [opened, setOpened] = useState<ReadonlySet<number>>(new Set());
  const rows = stepRows(steps, filter, shown, opened);
  return (
    <div className="step-list">
      <label className="check">
        <input type="checkbox" checked={follows} onChange={(event) => (event.target.checked ? follow() : view.dispatch({ type: "step", step: shown }))} />
        Follow the run
      </label>
      <input type="search" placeholder="Filter" aria-label="Filter the macro steps" value={filter} onChange={(event) => setFilter(event.target.value)} />
      {rows.length === 0 ? <p className="quiet pad">No macro step has that in its input or calls.</p> : <Rows rows={rows} shown={shown} onOpen={(first) => setOpened(new Set([...opened, first]))} />}
    </div>
  );
}

interface RowsProps {
  readonly rows: readonly StepRow[];
  readonly shown: number;
  readonly onOpen: (first: number) => void;
}

function Rows({ rows, shown, onOpen }: RowsProps) {
  const list = useRef<HTMLOListElement>(null);
  const inView = useRowsInView(list, ".step-rows", rows.length, kRow);
  const { first, end } = rows.length <= kWhole ? { first: 0, end: rows.length } : inView;
  const at = rows.findIndex((row) => row.kind === "step" && row.step.step === shown);
  useEffect(() => {
    if (at >= 0) showRow(list.current, ".step-rows", at, kRow);
  }, [at, rows.length]);
  return (
    <div className="step-rows">
      <ol ref={list} aria-label="Macro steps" style={{ height: rows.length * kRow }}>
        {rows.slice(first, end).map((row, i) => {
          const place = { index: first + i, count: rows.length };
          return row.kind === "step" ? (
            <StepItem key={row.step.step} {...place} step={row.step} isShown={row.step.step === shown} />
          ) : (
            <IdleItem key={`idle ${row.first}`} {...place} row={row} onOpen={onOpen} />
          );
        })}
      </ol>
    </div>
  );
}

/** Where in the whole list a row is. */
interface Place {
  readonly index: number;
  readonly count: number;
}

const StepItem = memo(function StepItem({ step, isShown, index, count }: Place & { readonly step: TraceStep; readonly isShown: boolean }) {
  return (
    <li style={{ top: index * kRow }} aria-posinset={index + 1} aria-setsize={count}>
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

function IdleItem({ row, index, count, onOpen }: Place & { readonly row: StepRow & { readonly kind: "idle" }; readonly onOpen: (first: number) => void }) {
  return (
    <li style={{ top: index * kRow }} aria-posinset={index + 1} aria-setsize={count}>
      <button type="button" className="step-idle" aria-expanded={false} onClick={() => onOpen(row.first)}>
        <b>▸</b>
        <span>{row.count} steps that changed nothing</span>
        <small>
          {row.first} to {row.last}
        </small>
      </button>
    </li>
  );
}
