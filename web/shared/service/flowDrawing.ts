// The data flows between services (thesis 4.1) as a drawing: who publishes, who subscribes, and what passes now.
import type { Box, Point } from "../drawing/drawing";
import type { ElkGraph, LayoutEngine } from "../drawing/elk";
import type { HostedService } from "../../generated/messages";

/** A flow from the service that offers it to one that reads it. */
export interface Flow {
  readonly id: string;
  readonly from: string;
  readonly flow: string;
  readonly to: string;
  /** Packets pass, and the reader wants them. */
  readonly flowing: boolean;
  /** [1/s] of world time. */
  readonly rate: number;
}

export interface FlowDrawing {
  readonly services: readonly (Box & { readonly key: string })[];
  readonly arrows: readonly { readonly id: string; readonly points: readonly Point[]; readonly label: Box }[];
  readonly width: number;
  readonly height: number;
}

/** What the drawing's shape depends on: its lines change when packets pass, its shape does not. */
export interface FlowShape {
  readonly keys: readonly string[];
  readonly flows: readonly Pick<Flow, "id" | "from" | "flow" | "to">[];
}

const kCharacter = 7;
const kMargin = 8;

/** All flows that a service reads, also from services that do not exist. */
export function flowsOf(services: readonly HostedService[]): readonly Flow[] {
  return services.flatMap((reader) =>
    reader.subscribes.map(({ service, flow, listening }) => {
      const rate = services.find((each) => each.key === service)?.publishes.find((each) => each.flow === flow)?.rate_hz ?? 0;
      return { id: `${service}.${flow}:${reader.key}`, from: service, flow, to: reader.key, flowing: listening && rate > 0, rate };
    }),
  );
}

/** What is drawn: the services of the flows that are read; where none is, all that publish one. */
export function flowShape(services: readonly HostedService[]): FlowShape {
  const flows = flowsOf(services).map(({ id, from, flow, to }) => ({ id, from, flow, to }));
  const publishers = services.filter((service) => service.publishes.length > 0).map((service) => service.key);
  return { keys: flows.length === 0 ? publishers : [...new Set(flows.flatMap(({ from, to }) => [from, to]))], flows };
}

function flowGraph({ keys, flows }: FlowShape): ElkGraph {
  return {
    id: "flows",
    layoutOptions: {
      "elk.algorithm": "layered",
      "elk.direction": "RIGHT",
      "elk.edgeRouting": "POLYLINE",
      "elk.spacing.nodeNode": "18",
      "elk.layered.spacing.nodeNodeBetweenLayers": "30",
      "elk.padding": `[top=${kMargin},left=${kMargin},bottom=${kMargin},right=${kMargin}]`,
    },
    children: keys.map((key) => ({ id: key, width: key.length * 8 + 40, height: 40 })),
    edges: flows.map(({ id, from, flow, to }) => ({
      id,
      sources: [from],
      targets: [to],
      labels: [{ id: `${id}:label`, text: flow, width: (flow.length + 8) * kCharacter, height: 16 }],
    })),
  };
}

const box = (shape: Partial<Box> | undefined): Box => ({ x: shape?.x ?? 0, y: shape?.y ?? 0, width: shape?.width ?? 0, height: shape?.height ?? 0 });

export async function drawFlows(engine: LayoutEngine, shape: FlowShape): Promise<FlowDrawing> {
  const graph = await engine(flowGraph(shape));
  return {
    services: (graph.children ?? []).map((node) => ({ key: node.id, ...box(node) })),
    arrows: (graph.edges ?? []).map((edge) => {
      const section = edge.sections?.[0];
      const points = section === undefined ? [] : [section.startPoint, ...(section.bendPoints ?? []), section.endPoint];
      return { id: edge.id, points, label: box(edge.labels?.[0]) };
    }),
    width: graph.width ?? 0,
    height: graph.height ?? 0,
  };
}
