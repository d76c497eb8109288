// The time line of the shown run: bars of states and calls, plots of numbers. A click goes to that macro step.
import { lazy, Suspense, useMemo, useState } from "react";
import { csvOf, lineStep, timelineOf, type LineStep } from "../../shared/runs/timeline";
import { useSession } from "../client";
import { saveText } from "../saveText";
import { useSteps, type LoadedSteps } from "./loading";
import { CallBars, StateBars } from "./StateBars";

const ValuePlot = lazy(() => import("./ValuePlot").then(({ ValuePlot }) => ({ default: ValuePlot })));

export function TimelinePanel() {
  const line = useSteps(lineStep);
  if (line === undefined || line.steps.length === 0) {
    return (
      <section className="timeline" aria-label="Time line">
        <p className="quiet pad">{line?.failed ?? "The time line of a run appears here as soon as it has a macro step."}</p>
      </section>
    );
  }
  return <Lines line={line} />;
}

function Lines({ line: { id, steps, failed } }: { readonly line: LoadedSteps<LineStep> }) {
  const timeline = useMemo(() => timelineOf(steps), [steps]);
  const at = useSession((s) => s.past?.past.step);
  const [wanted, setWanted] = useState<string>();
  const name = timeline.numbers.find((each) => each === wanted) ?? timeline.numbers[0];
  return (
    <section className="timeline" aria-label="Time line">
      <header className="timeline-head">
        <h3>
          Macro steps {timeline.first} to {timeline.last}
        </h3>
        {failed !== undefined && <span className="bad">{failed}</span>}
        {timeline.numbers.length > 0 && (
          <label>
            Plot{" "}
            <select value={name} onChange={(event) => setWanted(event.target.value)}>
              {timeline.numbers.map((each) => (
                <option key={each}>{each}</option>
              ))}
            </select>
          </label>
        )}
        <button type="button" onClick={() => saveText(`run-${id}.csv`, "text/csv", csvOf(steps))}>
          Values as CSV
        </button>
      </header>
      <div className="timeline-lines">
        {name !== undefined && (
          <Suspense fallback={<p className="quiet pad">Loading the plot…</p>}>
            <ValuePlot steps={steps} name={name} at={at} />
          </Suspense>
        )}
        <StateBars timeline={timeline} at={at} />
        <CallBars timeline={timeline} at={at} />
      </div>
    </section>
  );
}
