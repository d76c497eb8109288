// One row of the time line: bars from where to where something lasted. A click goes to the macro step there.
import type { MouseEvent, ReactNode } from "react";
import { barOf, type Scale } from "../../shared/runs/scale";
import type { Span } from "../../shared/runs/timeline";
import { visitStep } from "../past/past";

interface Props {
  readonly scale: Scale;
  /** The macro step that is shown; nothing: the present. */
  readonly at: number | undefined;
  readonly label: string;
  readonly kind: "state" | "call" | "failed";
  readonly spans: readonly Span[];
}

/** Goes to the macro step at which a row was clicked. */
export function visitAt(event: MouseEvent, scale: Scale): void {
  const box = event.currentTarget.getBoundingClientRect();
  visitStep(scale.stepAt(((event.clientX - box.left) / box.width) * scale.width));
}

/** The bars as one outline. */
const outline = (spans: readonly Span[], scale: Scale): string =>
  spans
    .map((span) => {
      const [begin, end] = barOf(span, scale);
      return `M${begin} 0H${end}V1H${begin}Z`;
    })
    .join("");

export function Track({ scale, at, label, kind, spans }: Props) {
  return (
    <svg className={`track is-${kind}`} viewBox={`0 0 ${scale.width} 1`} preserveAspectRatio="none" role="img" aria-label={label} onClick={(event) => visitAt(event, scale)}>
      <path d={outline(spans, scale)} />
      {at !== undefined && <path className="track-at" d={`M${scale.at(at + 1)} 0V1`} />}
    </svg>
  );
}

interface RowProps {
  readonly name: string;
  readonly title: string;
  /** What stands behind the name. */
  readonly detail?: string | undefined;
  readonly go: () => void;
  readonly children: ReactNode;
}

export function TrackRow({ name, title, detail, go, children }: RowProps) {
  return (
    <li>
      <button type="button" className="track-name" title={title} onClick={go}>
        <span>{name}</span>
        {detail !== undefined && <small>{detail}</small>}
      </button>
      {children}
    </li>
  );
}
