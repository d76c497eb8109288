// ELK in workers, loaded with the first drawing: the page stays responsive while a large model is laid out.
import type { ELK, ElkNode } from "elkjs/lib/elk-api";
import workerUrl from "elkjs/lib/elk-worker.min.js?url";
import type { ElkGraph, LayoutEngine } from "../../shared/drawing/elk";
import { createPool } from "../../shared/drawing/pool";

/** Starting more workers costs more time than they save. */
const kWorkers = Math.max(1, Math.min(4, navigator.hardwareConcurrency - 1));

/** Resolves with the first answer of the worker: a worker whose file cannot be loaded never answers. */
async function load(): Promise<ELK> {
  const { default: Elk } = await import("elkjs/lib/elk-api");
  const worker = new Worker(workerUrl);
  const elk = new Elk({ workerFactory: () => worker });
  await new Promise((resolve, reject) => {
    worker.addEventListener("error", () => reject(new Error("the layout does not start")));
    elk.knownLayoutAlgorithms().then(resolve, reject);
  });
  return elk;
}

const withWorker = createPool(load, kWorkers);

/** Work that waits for a worker when `signal` is aborted is not started. */
export function layoutInWorkers(signal?: AbortSignal): LayoutEngine {
  return (graph) =>
    withWorker(async (elk) => {
      signal?.throwIfAborted();
      return (await elk.layout(graph as ElkNode)) as ElkGraph;
    });
}
