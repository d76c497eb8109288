// Rows of bars over macro steps: when a state was active, and from where to where a call was open.
import type { MouseEvent } from "react";
import { nameOf } from "../../shared/model/modelTree";
import type { CallSpan, Span, Timeline } from "../../shared/runs/timeline";
import { view } from "../client";
import { visitStep } from "../past/past";

interface Props {
  readonly timeline: Timeline;
  /** The macro step that is shown; nothing: the present. */
  readonly at: number | undefined;
}

/** So many calls have a row, the last ones. */
const kMostCalls = 100;

/** The bars as one outline, a macro step wide each at least. */
const outline = (spans: readonly Span[], first: number, last: number): string =>
  spans.map(({ from, to = last + 1 }) => `M${from - first} 0H${Math.max(to, from + 0.5) - first}V1H${from - first}Z`).join("");

const spanText = ({ from, to }: Span): string => (to === undefined ? `from step ${from} on` : to === from ? `in step ${from}` : `from step ${from} to ${to}`);

interface TrackProps extends Props {
  readonly spans: readonly Span[];
  readonly label: string;
  readonly kind: "state" | "call" | "failed";
}

function Track({ timeline: { first, last }, at, spans, label, kind }: TrackProps) {
  const count = last - first + 1;
  const go = (event: MouseEvent<SVGSVGElement>) => {
    const box = event.currentTarget.getBoundingClientRect();
    visitStep(first + Math.min(count - 1, Math.max(0, Math.floor(((event.clientX - box.left) / box.width) * count))));
  };
  return (
    <svg className={`track is-${kind}`} viewBox={`0 0 ${count} 1`} preserveAspectRatio="none" role="img" aria-label={label} onClick={go}>
      <path d={outline(spans, first, last)} />
      {at !== undefined && <path className="track-at" d={`M${at - first + 1} 0V1`} />}
    </svg>
  );
}

export function StateBars({ timeline, at }: Props) {
  return (
    <ul className="track-rows" aria-label="States over macro steps">
      {timeline.states.map(({ path, spans }) => (
        <li key={path}>
          <button type="button" className="track-name" title={path} onClick={() => view.dispatch({ type: "jump", selection: { kind: "node", path } })}>
            {nameOf(path)}
          </button>
          <Track timeline={timeline} at={at} spans={spans} kind="state" label={`${path}: active ${spans.slice(0, 20).map(spanText).join(", ")}`} />
        </li>
      ))}
    </ul>
  );
}

const callLabel = ({ text, failed, ...span }: CallSpan): string => `${text}, ${spanText(span)}${span.to === undefined ? ", not answered" : failed ? ", answered by an error" : ""}`;

export function CallBars({ timeline, at }: Props) {
  const calls = timeline.calls.slice(-kMostCalls);
  if (calls.length === 0) return null;
  return (
    <>
      <h4>Calls{calls.length < timeline.calls.length ? `, the last ${kMostCalls} of ${timeline.calls.length}` : ""}</h4>
      <ul className="track-rows" aria-label="Calls over macro steps">
        {calls.map((call) => (
          <li key={call.call}>
            <button type="button" className="track-name" title={callLabel(call)} onClick={() => visitStep(call.from)}>
              {call.text}
            </button>
            <Track timeline={timeline} at={at} spans={[call]} kind={call.failed ? "failed" : "call"} label={callLabel(call)} />
          </li>
        ))}
      </ul>
    </>
  );
}
