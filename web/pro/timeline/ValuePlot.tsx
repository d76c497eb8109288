// A number of the run over its macro steps or seconds, plotted by uPlot; a click goes to that macro step.
import { useEffect, useRef } from "react";
import UPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import type { Scale } from "../../shared/runs/scale";
import { seriesOf, type LineStep } from "../../shared/runs/timeline";
import { visitStep } from "../past/past";
import { listenToTheme } from "../theme/theme";
import { tokenColours } from "../theme/tokenColour";
import { overText } from "./StateBars";

const kHeight = 120;
/** The names of the rows beside it are as wide (timeline.css) [px]. */
const kAxis = 180;

interface Props {
  readonly steps: readonly LineStep[];
  readonly scale: Scale;
  readonly name: string;
  readonly at: number | undefined;
}

/** A value holds until another one is set. */
const kHold = UPlot.paths.stepped?.({ align: 1 });

const kStepsApart = [1, 2, 5, 10, 20, 50, 100, 200, 500];

/** Where the left end is: each macro step is plotted in the middle of its room. */
const leftOf = ({ measure, origin }: Scale): number => origin - (measure === "steps" ? 0.5 : 0);
/** Where a macro step is plotted: at its number, or when it began. */
const placeOf = ({ origin, at }: Scale, step: number): number => origin + at(step);

function optionsOf(width: number, scale: Scale, name: string): UPlot.Options {
  const [ink, edge, line] = tokenColours(["--soft", "--edge", "--accent"]);
  const axis = { stroke: ink ?? "", grid: { stroke: edge ?? "", width: 1 }, ticks: { stroke: edge ?? "", width: 1 } };
  return {
    width, height: kHeight, legend: { show: false }, cursor: { drag: { x: false, y: false } },
    padding: [10, 0, 0, 0],
    // As in the rows of bars.
    scales: { x: { time: false, range: () => [leftOf(scale), leftOf(scale) + scale.width] } },
    series: [{}, { label: name, stroke: line ?? "", width: 1.5, points: { show: false }, spanGaps: false, ...(kHold && { paths: kHold }) }],
    axes: [{ ...axis, size: 24, ...(scale.measure === "steps" && { incrs: kStepsApart }) }, { ...axis, size: kAxis }],
  };
}

export function ValuePlot({ steps, scale, name, at }: Props) {
  const frame = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const place = frame.current;
    if (place === null) return;
    const data: UPlot.AlignedData = [steps.map(({ step }) => placeOf(scale, step)), [...seriesOf(steps, name)]];
    let plot: UPlot | undefined;
    const draw = () => {
      plot?.destroy();
      plot = new UPlot(optionsOf(place.clientWidth, scale, name), data, place);
      const made = plot;
      made.over.addEventListener("click", () => {
        const step = steps[made.cursor.idx ?? -1]?.step;
        if (step !== undefined) visitStep(step);
      });
      if (at !== undefined) made.setCursor({ left: made.valToPos(placeOf(scale, at), "x"), top: kHeight / 2 });
    };
    draw();
    const sizes = new ResizeObserver(() => plot?.setSize({ width: place.clientWidth, height: kHeight }));
    sizes.observe(place);
    const endTheme = listenToTheme(draw);
    return () => {
      endTheme();
      sizes.disconnect();
      plot?.destroy();
    };
  }, [steps, scale, name, at]);
  return <div ref={frame} className="value-plot" role="img" aria-label={`${name} over ${overText(scale)}`} />;
}
