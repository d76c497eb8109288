// ELK in a worker, loaded with the first drawing: the page stays responsive while a large model is laid out.
import type { ELK, ElkNode } from "elkjs/lib/elk-api";
import workerUrl from "elkjs/lib/elk-worker.min.js?url";
import type { ElkGraph, LayoutEngine } from "../../shared/drawing/elk";

let engine: Promise<ELK> | undefined;

async function load(): Promise<ELK> {
  const { default: Elk } = await import("elkjs/lib/elk-api");
  return new Elk({ workerFactory: () => new Worker(workerUrl) });
}

export const layoutInWorker: LayoutEngine = async (graph) => {
  engine ??= load();
  const answer = await (await engine).layout(graph as ElkNode);
  return answer as ElkGraph;
};
