// The drawing of an RSM: present state lit, the transition taken last marked, deferrals dashed.
import { useEffect, useState } from "react";
import { roundedPath } from "../../shared/drawing/path";
import type { Rsm } from "../../generated/messages";
import { drawRsm, kRsmLine, type RsmDrawing } from "../../shared/service/rsmDrawing";
import { layoutInWorkers } from "../canvas/layoutEngine";

const kCorner = 9;
/** A wider drawing is not legible in one column of the page. */
const kWide = 600;

interface Props {
  readonly rsm: Rsm;
  readonly state: string | null;
  readonly last: string | undefined;
}

export function RsmFigure({ rsm, state, last }: Props) {
  const [drawing, setDrawing] = useState<RsmDrawing>();
  useEffect(() => {
    let current = true;
    void drawRsm(layoutInWorkers(), rsm).then((next) => current && setDrawing(next));
    return () => {
      current = false;
    };
  }, [rsm]);
  const isLast = (transitions: readonly string[]) => last !== undefined && transitions.includes(last);
  if (drawing === undefined) return <p className="quiet">Drawing…</p>;
  return (
    <svg
      className={`rsm${drawing.width > kWide ? " is-wide" : ""}`}
      role="img"
      aria-label={`${rsm.name}, now in ${state ?? "no state"}`}
      viewBox={`0 0 ${drawing.width} ${drawing.height}`}
      style={{ maxWidth: drawing.width, aspectRatio: `${drawing.width} / ${drawing.height}` }}
    >
      {drawing.arrows.map((arrow) => (
        <path key={arrow.id} className={`rsm-arrow${isLast(arrow.transitions) ? " is-last" : ""}`} d={roundedPath(arrow.points, kCorner)} markerEnd="url(#arrow-rsm)" />
      ))}
      {drawing.start.length > 0 && <path className="rsm-arrow" d={roundedPath(drawing.start, kCorner)} markerEnd="url(#arrow-rsm)" />}
      {drawing.arrows.map((arrow) => (
        <g key={arrow.id} className={`rsm-label${arrow.label.spontaneous ? " is-spontaneous" : ""}${isLast(arrow.transitions) ? " is-last" : ""}`}>
          <rect x={arrow.label.x} y={arrow.label.y} width={arrow.label.width} height={arrow.label.height} rx={5} />
          <text>
            {arrow.label.lines.map((line, i) => (
              <tspan key={line} x={arrow.label.x + arrow.label.width / 2} y={arrow.label.y + 13 + i * kRsmLine}>
                {line}
              </tspan>
            ))}
          </text>
        </g>
      ))}
      {drawing.states.map((box) =>
        box.kind === "init" ? (
          <circle key="init" className="rsm-init" cx={box.x + 5} cy={box.y + 5} r={5} />
        ) : (
          <g key={box.name} className={`rsm-state is-${box.kind}${box.kind === "state" && box.name === state ? " is-active" : ""}`}>
            <rect x={box.x} y={box.y} width={box.width} height={box.height} rx={10} />
            <text x={box.x + box.width / 2} y={box.y + box.height / 2 + 4.5}>
              {box.name}
            </text>
          </g>
        ),
      )}
      {drawing.deferrals.map((link) => (
        <path key={link.id} className="rsm-deferral" d={link.path}>
          <title>deferred: answered by this transition</title>
        </path>
      ))}
      <defs>
        <marker id="arrow-rsm" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" markerHeight="8" markerUnits="userSpaceOnUse" orient="auto">
          <path className="arrow-plain" d="M 0 0.5 L 10 5 L 0 9.5 z" />
        </marker>
      </defs>
    </svg>
  );
}
