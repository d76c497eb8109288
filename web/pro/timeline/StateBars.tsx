// Rows of bars: when a state was active, from where to where a call was open and for how long.
import { nameOf } from "../../shared/model/modelTree";
import type { Scale } from "../../shared/runs/scale";
import { durationOf, secondsAt, secondsText, type Times } from "../../shared/runs/times";
import type { CallSpan, Span, Timeline } from "../../shared/runs/timeline";
import { view } from "../client";
import { visitStep } from "../past/past";
import { Track, TrackRow } from "./Track";

interface Props {
  readonly timeline: Timeline;
  readonly times: Times | undefined;
  readonly scale: Scale;
  /** The macro step that is shown; nothing: the present. */
  readonly at: number | undefined;
}

/** So many calls have a row, the last ones. */
const kMostCalls = 100;
/** So many spans are told to who does not see them. */
const kMostTold = 20;

/** What the rows of a time line are drawn over. */
export const overText = ({ measure }: Scale): string => (measure === "steps" ? "macro steps" : "time");

const spanText = ({ from, to }: Span): string => (to === undefined ? `from step ${from} on` : to === from ? `in step ${from}` : `from step ${from} to ${to}`);

/** The macro steps of a span, and its seconds if they are known. */
function timedText(span: Span, times: Times | undefined): string {
  const [begin, end] = [times && secondsAt(times, span.from), times && span.to !== undefined ? secondsAt(times, span.to) : undefined];
  return begin === undefined || end === undefined ? spanText(span) : `${spanText(span)} (${secondsText(end - begin)})`;
}

export function StateBars({ timeline, times, scale, at }: Props) {
  return (
    <ul className="track-rows" aria-label={`States over ${overText(scale)}`}>
      {timeline.states.map(({ path, spans }) => (
        <TrackRow key={path} name={nameOf(path)} title={path} go={() => view.dispatch({ type: "jump", selection: { kind: "node", path } })}>
          <Track scale={scale} at={at} spans={spans} kind="state" label={`${path}: active ${spans.slice(0, kMostTold).map((span) => timedText(span, times)).join(", ")}`} />
        </TrackRow>
      ))}
    </ul>
  );
}

function callLabel(call: CallSpan, times: Times | undefined): string {
  const seconds = durationOf(call, times);
  const answer = call.to === undefined ? ", not answered" : call.failed ? ", answered by an error" : "";
  return `${call.text}, ${spanText(call)}${answer}${seconds === undefined ? "" : ` after ${secondsText(seconds)}`}`;
}

export function CallBars({ timeline, times, scale, at }: Props) {
  const calls = timeline.calls.slice(-kMostCalls);
  if (calls.length === 0) return null;
  return (
    <>
      <h4>Calls{calls.length < timeline.calls.length ? `, the last ${kMostCalls} of ${timeline.calls.length}` : ""}</h4>
      <ul className="track-rows" aria-label={`Calls over ${overText(scale)}`}>
        {calls.map((call) => {
          const seconds = durationOf(call, times);
          return (
            <TrackRow key={call.call} name={call.text} title={callLabel(call, times)} detail={seconds === undefined ? undefined : secondsText(seconds)} go={() => visitStep(call.from)}>
              <Track scale={scale} at={at} spans={[call]} kind={call.failed ? "failed" : "call"} label={callLabel(call, times)} />
            </TrackRow>
          );
        })}
      </ul>
    </>
  );
}
