// The time line of the shown run: bars of states, services and calls, plots of numbers. A click goes to the macro step there.
import { lazy, Suspense, useMemo, useState } from "react";
import { isOver } from "../../shared/run/controls";
import { scaleOf, type Measure, type Scale } from "../../shared/runs/scale";
import { servicesShown } from "../../shared/runs/times";
import { csvOf, lineStep, timelineOf, type LineStep } from "../../shared/runs/timeline";
import { watchedCore } from "../../shared/session/session";
import { useSession } from "../client";
import { saveText } from "../saveText";
import { measureBy, useMeasure } from "./axis";
import { useSteps, useStepsToCome, type LoadedSteps } from "./loading";
import { ServiceBars } from "./ServiceBars";
import { CallBars, StateBars } from "./StateBars";
import { useTimes } from "./times";
import { counted } from "../../shared/counted";

const ValuePlot = lazy(() => import("./ValuePlot").then(({ ValuePlot }) => ({ default: ValuePlot })));

export function TimelinePanel() {
  const line = useSteps(lineStep);
  const toCome = useStepsToCome(line);
  if (line === undefined || line.steps.length === 0) {
    return (
      <section className="timeline" aria-label="Time line">
        <p className="quiet pad">{line?.failed ?? (toCome ? "Loading the steps of the run…" : "The time line of a run appears here as soon as it has a macro step.")}</p>
      </section>
    );
  }
  return <Lines line={line} />;
}

function Lines({ line: { id, steps, failed } }: { readonly line: LoadedSteps<LineStep> }) {
  const timeline = useMemo(() => timelineOf(steps), [steps]);
  const { times, failed: noTimes } = useTimes(id, timeline.first, timeline.last);
  const measure = useMeasure();
  const over = useSession((s) => {
    const core = watchedCore(s);
    return core !== undefined && isOver(core) && timeline.last >= core.step;
  });
  const scale = useMemo(() => scaleOf(measure, timeline, times, over), [measure, timeline, times, over]);
  const at = useSession((s) => s.past?.past.step);
  const [wanted, setWanted] = useState<string>();
  const name = timeline.numbers.find((each) => each === wanted) ?? timeline.numbers[0];
  const refused = failed ?? noTimes;
  return (
    <section className="timeline" aria-label="Time line">
      <header className="timeline-head">
        <h3>
          Macro steps {timeline.first} to {timeline.last}
        </h3>
        {refused !== undefined && <span className="bad">{refused}</span>}
        <Axis measure={measure} scale={scale} isLoaded={times !== undefined} />
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
        <button type="button" onClick={() => saveText(`run-${id}.csv`, "text/csv", csvOf(steps, times))}>
          Values as CSV
        </button>
      </header>
      <div className="timeline-lines">
        {name !== undefined && (
          <Suspense fallback={<p className="quiet pad">Loading the plot…</p>}>
            <ValuePlot steps={steps} scale={scale} name={name} at={at} />
          </Suspense>
        )}
        <StateBars timeline={timeline} times={times} scale={scale} at={at} />
        {times !== undefined && <ServiceBars services={servicesShown(times, steps)} scale={scale} at={at} />}
        <CallBars timeline={timeline} times={times} scale={scale} at={at} />
      </div>
    </section>
  );
}

interface AxisProps {
  readonly measure: Measure;
  readonly scale: Scale;
  readonly isLoaded: boolean;
}

/** The choice of the axis, and what of it is not known. */
function Axis({ measure, scale, isLoaded }: AxisProps) {
  const isMissing = isLoaded && measure === "seconds" && scale.measure === "steps";
  return (
    <>
      {isMissing && <span className="quiet">The times of these steps are not known.</span>}
      {scale.unknown > 0 && (
        <span className="quiet">{counted(scale.unknown, "step has", "steps have")} no known time.</span>
      )}
      <label>
        Axis{" "}
        <select value={measure} onChange={(event) => measureBy(event.target.value === "steps" ? "steps" : "seconds")}>
          <option value="seconds">seconds</option>
          <option value="steps">macro steps</option>
        </select>
      </label>
    </>
  );
}
