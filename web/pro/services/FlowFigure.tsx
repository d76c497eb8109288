// The drawing of the data flows between services: an arrow is thick while packets pass.
import { useEffect, useMemo, useState } from "react";
import type { Point } from "../../shared/drawing/drawing";
import { drawFlows, flowShape, flowsOf, type Flow, type FlowDrawing } from "../../shared/service/flowDrawing";
import type { HostedService } from "../../generated/messages";
import { layoutInWorkers } from "../canvas/layoutEngine";

const rateText = (flow: Flow) => (flow.flowing ? `${flow.flow} ${flow.rate.toFixed(1)}/s` : flow.flow);
const sentence = (flow: Flow) => `${flow.from} publishes ${flow.flow} to ${flow.to}, ${flow.flowing ? `${flow.rate.toFixed(1)} packets per second` : "no packets now"}`;
const path = (points: readonly Point[]) => points.map(({ x, y }, i) => `${i === 0 ? "M" : "L"} ${x} ${y}`).join(" ");

/** Laid out again when a service or a flow is added or removed, not with every packet. */
function useFlowDrawing(services: readonly HostedService[]): FlowDrawing | undefined {
  const [drawing, setDrawing] = useState<FlowDrawing>();
  const text = useMemo(() => JSON.stringify(flowShape(services)), [services]);
  useEffect(() => {
    let current = true;
    void drawFlows(layoutInWorkers(), JSON.parse(text) as ReturnType<typeof flowShape>).then((next) => current && setDrawing(next));
    return () => {
      current = false;
    };
  }, [text]);
  return drawing;
}

export function FlowFigure({ services }: { readonly services: readonly HostedService[] }) {
  const drawing = useFlowDrawing(services);
  const flows = flowsOf(services);
  if (drawing === undefined) return <p className="quiet">Drawing…</p>;
  return (
    <svg
      className="flows"
      role="img"
      aria-label={flows.map(sentence).join("; ") || "No service reads a data flow"}
      viewBox={`0 0 ${drawing.width} ${drawing.height}`}
      style={{ maxWidth: drawing.width, aspectRatio: `${drawing.width} / ${drawing.height}` }}
    >
      <defs>
        {["flow-idle", "flow-busy"].map((kind) => (
          <marker key={kind} id={kind} viewBox="0 0 10 10" refX="9" refY="5" markerWidth="11" markerHeight="11" markerUnits="userSpaceOnUse" orient="auto">
            <path d="M 0 0.5 L 10 5 L 0 9.5 z" />
          </marker>
        ))}
      </defs>
      {drawing.arrows.map(({ id, points, label }) => {
        const flow = flows.find((each) => each.id === id);
        if (flow === undefined) return null;
        return (
          <g key={id} data-flow={id} className={`flow${flow.flowing ? " is-flowing" : ""}`}>
            <path d={path(points)} markerEnd={flow.flowing ? "url(#flow-busy)" : "url(#flow-idle)"} />
            {flow.flowing && <path className="flow-pulse" d={path(points)} />}
            <text x={label.x + label.width / 2} y={label.y + 12}>
              {rateText(flow)}
            </text>
          </g>
        );
      })}
      {drawing.services.map((service) => (
        <g key={service.key} className="flow-service">
          <rect x={service.x} y={service.y} width={service.width} height={service.height} rx={8} />
          <text x={service.x + service.width / 2} y={service.y + service.height / 2 + 4.5}>
            {service.key}
          </text>
        </g>
      ))}
    </svg>
  );
}
