import ELK from "elkjs/lib/elk.bundled.js";
import { describe, expect, it } from "vitest";
import type { ElkGraph, LayoutEngine } from "../../shared/drawing/elk";
import type { HostedService, PublishedFlow, SubscribedFlow } from "../../generated/messages";
import { drawFlows, flowShape, flowsOf } from "../../shared/service/flowDrawing";

const elk = new ELK();
const engine: LayoutEngine = async (graph) => (await elk.layout(graph as Parameters<typeof elk.layout>[0])) as ElkGraph;

function service(key: string, publishes: readonly PublishedFlow[], subscribes: readonly SubscribedFlow[]): HostedService {
  const rsm = { rsm: 1, name: key, operations: [], events: [] } as const;
  return { key, type: key, state: null, available: true, pending_count: 0, pending: [], violations: [], publishes, subscribes, rsm };
}

/** A camera at this rate that is read, and a service without flows. */
function services(rate: number, listening: boolean): readonly HostedService[] {
  return [
    service("obj_rec", [], [{ service: "camera", flow: "frame", listening }]),
    service("camera", [{ flow: "frame", watchers: 1, rate_hz: rate }], []),
    service("timer", [], []),
  ];
}

describe("flowsOf", () => {
  it("leads from the service that offers a flow to the one that reads it", () => {
    const [flow, ...others] = flowsOf(services(10, true));
    expect(flow).toEqual({ id: "camera.frame:obj_rec", from: "camera", flow: "frame", to: "obj_rec", flowing: true, rate: 10 });
    expect(others).toEqual([]);
  });
  it("does not flow to a reader that does not listen, though the page watches", () => expect(flowsOf(services(10, false))[0]?.flowing).toBe(false));
  it("does not flow while no packets pass", () => expect(flowsOf(services(0, true))[0]?.flowing).toBe(false));
  it("shows a service that does not exist, without packets", () => {
    const alone = flowsOf(services(10, true).slice(0, 1))[0];
    expect([alone?.from, alone?.rate, alone?.flowing]).toEqual(["camera", 0, false]);
  });
});

describe("drawFlows", () => {
  it("has the services with flows alone, the reader to the right of the publisher, and the label between", async () => {
    const drawing = await drawFlows(engine, flowShape(services(10, true)));
    const [camera, reader] = ["camera", "obj_rec"].map((key) => drawing.services.find((each) => each.key === key));
    const [arrow] = drawing.arrows;
    if (camera === undefined || reader === undefined || arrow === undefined) throw new Error("something is not drawn");
    expect(drawing.services.length).toBe(2);
    expect(arrow.points[0]?.x).toBe(camera.x + camera.width);
    expect(arrow.points.at(-1)?.x).toBe(reader.x);
    expect(arrow.label.x).toBeGreaterThan(camera.x + camera.width);
    expect(arrow.label.x + arrow.label.width).toBeLessThan(reader.x);
  });
  it("leaves out a service whose flows only pages read, unless no service reads any", () => {
    const robot = service("robot", [{ flow: "control", watchers: 1, rate_hz: 5 }], []);
    expect(flowShape([robot, ...services(10, true)]).keys).toEqual(["camera", "obj_rec"]);
    expect(flowShape([robot]).keys).toEqual(["robot"]);
  });
  it("keeps its shape while only the rate changes", () => expect(flowShape(services(10, true))).toEqual(flowShape(services(0, false))));
});
