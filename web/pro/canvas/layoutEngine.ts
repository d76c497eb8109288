// ELK in workers, loaded with the first drawing that is new to this browser: the page stays responsive while a large model is laid out.
import type { ELK, ElkNode } from "elkjs/lib/elk-api";
import workerUrl from "elkjs/lib/elk-worker.min.js?url";
import type { ElkGraph, LayoutEngine } from "../../shared/drawing/elk";
import { keeping } from "../../shared/drawing/keptLayouts";
import { createPool } from "../../shared/drawing/pool";
import { layoutStore } from "./layoutStore";

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

/** What this browser has laid out before is not laid out again. Work that waits for a worker when `signal` is aborted is not started. */
export function layoutInWorkers(signal?: AbortSignal): LayoutEngine {
  const inWorker: LayoutEngine = (graph) =>
    withWorker(async (elk) => {
      signal?.throwIfAborted();
      return (await elk.layout(graph as ElkNode)) as ElkGraph;
    });
  return keeping(inWorker, layoutStore);
}
