// A line of the drawing along the points of the layout: transitions, forks, the arrow to `first`, dashed exits.
import { BaseEdge, type Edge, type EdgeProps } from "@xyflow/react";
import type { DrawnLine } from "../../shared/drawing/drawing";
import { lineState } from "../../shared/drawing/live";
import { roundedPath } from "../../shared/drawing/path";
import { useView } from "../client";
import { useLive } from "./useLive";

export type LineFlowEdge = Edge<{ readonly line: DrawnLine }, "line">;

export function ModelLine({ id, data }: EdgeProps<LineFlowEdge>) {
  const line = data?.line;
  const state = useLive((live) => (line === undefined ? "idle" : lineState(line, live)));
  const fireCount = useLive((live) => (state === "fired" ? live.fireCount : 0));
  const touched = useView(
    (v) =>
      line !== undefined &&
      v.selection !== undefined &&
      (v.selection.kind === "port"
        ? v.selection.address === line.from || v.selection.address === line.to
        : line.from.startsWith(`${v.selection.path}.`) || line.to === v.selection.path),
  );
  return line === undefined ? null : <LineShape key={fireCount} id={id} kind={line.kind} points={line.points} state={state} touched={touched} />;
}

interface Shape extends Pick<DrawnLine, "kind" | "points"> {
  readonly id: string;
  readonly state: ReturnType<typeof lineState>;
  readonly touched: boolean;
}

/** How a line looks, in the drawing and in the legend. */
export function LineShape({ id, kind, points, state, touched }: Shape) {
  const start = points[0];
  const marker = kind === "exit" || kind === "nowhere" ? "open" : state === "fired" ? "fired" : "plain";
  return (
    <g className={`line line-${kind} is-${state}${touched ? " is-touched" : ""}`}>
      <BaseEdge id={id} path={roundedPath(points, 7)} markerEnd={`url(#arrow-${marker})`} interactionWidth={0} />
      {kind === "first" && start !== undefined && <circle className="line-start" cx={start.x} cy={start.y} r={4} />}
    </g>
  );
}

/** The arrow heads, once per page. */
export function ArrowHeads() {
  return (
    <svg className="arrow-heads" aria-hidden="true">
      <defs>
        {["plain", "fired", "open"].map((name) => (
          <marker key={name} id={`arrow-${name}`} viewBox="0 0 10 10" refX="9" refY="5" markerWidth="9" markerHeight="9" markerUnits="userSpaceOnUse" orient="auto">
            <path className={`arrow-${name}`} d={name === "open" ? "M 1 1 L 9 5 L 1 9" : "M 0 0.5 L 10 5 L 0 9.5 z"} />
          </marker>
        ))}
      </defs>
    </svg>
  );
}
