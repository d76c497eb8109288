// Layouts that are kept beyond the page: a graph that was laid out once, maybe yesterday, needs no engine.
import type { ElkGraph, LayoutEngine } from "./elk";

/** A graph and its layout, both as JSON. */
export interface KeptLayout {
  readonly graph: string;
  readonly answer: string;
}

/** Where layouts are kept. What it cannot give or take is computed: a rejected promise does no harm. */
export interface LayoutStore {
  readonly get: (key: string) => Promise<KeptLayout | undefined>;
  readonly set: (key: string, kept: KeptLayout) => Promise<void>;
}

/** A longer graph [characters] is not kept. */
const kLongest = 64_000;

/** A short name of a text; two texts may have the same (FNV-1a, 32 bit, with the length). */
export function keyOfText(text: string): string {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; i++) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return `${text.length}-${(hash >>> 0).toString(36)}`;
}

/** What a drawing takes of a layout: an engine says more. */
const kDrawn = ["id", "x", "y", "width", "height", "ports", "children", "edges", "sources", "targets", "sections", "startPoint", "endPoint", "bendPoints", "labels", "text"];

/** An engine that asks the store first, and keeps in it what `engine` has laid out. */
export function keeping(engine: LayoutEngine, store: LayoutStore): LayoutEngine {
  return async (graph) => {
    const text = JSON.stringify(graph);
    if (text.length > kLongest) return engine(graph);
    const key = keyOfText(text);
    const kept = await store.get(key).then((found) => (found?.graph === text ? (JSON.parse(found.answer) as ElkGraph) : undefined)).catch(() => undefined);
    if (kept !== undefined) return kept;
    const answer = await engine(graph);
    void store.set(key, { graph: text, answer: JSON.stringify(answer, kDrawn) }).catch(() => undefined);
    return answer;
  };
}
