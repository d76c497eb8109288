// The drawing of what the view shows, laid out anew when the model, the focus, what is collapsed or the detail changes.
import { useEffect, useMemo, useState } from "react";
import type { Drawing } from "../../shared/drawing/drawing";
import { readable } from "../../shared/drawing/fit";
import { layoutModel } from "../../shared/drawing/layout";
import { layoutMemory } from "../../shared/drawing/layoutMemory";
import { details, type Detail, type Size } from "../../shared/drawing/measure";
import { buildTree, stateAt, type ModelTree } from "../../shared/model/modelTree";
import type { Shown } from "../../shared/session/view";
import { problem, useSession, useView } from "../client";
import { layoutInWorkers } from "./layoutEngine";

export interface Laid {
  readonly drawing: Drawing;
  readonly detail: Detail;
  /** What of the view it shows. */
  readonly shows: Shown;
  /** The detail was asked for, so it must be large enough to be read at first. */
  readonly asked: boolean;
  /** What the canvas fits itself to: changes with the model, the focus and the detail. */
  readonly key: string;
}

/** How far the next drawing is: composites laid out, of how many. */
export interface Progress {
  readonly done: number;
  readonly of: number;
}

export interface CanvasDrawing {
  readonly laid: Laid | undefined;
  /** None: what is drawn is what the view shows. */
  readonly progress: Progress | undefined;
  /** The latest drawing did not succeed. */
  readonly failed: boolean;
  /** Another drawing, or one with more detail, may still come. */
  readonly busy: boolean;
}

export function useTree(): ModelTree | undefined {
  const model = useSession((session) => session.model);
  return useMemo(() => (model === undefined ? undefined : buildTree(model.root)), [model]);
}

const memory = layoutMemory();

export function useDrawing(tree: ModelTree | undefined, canvas: Size | undefined): CanvasDrawing {
  const focus = useView((view) => view.focus);
  const collapsed = useView((view) => view.collapsed);
  const wanted = useView((view) => view.detail);
  const [laid, setLaid] = useState<Laid>();
  const [progress, setProgress] = useState<Progress>();
  const [failed, setFailed] = useState(false);
  const [busy, setBusy] = useState(false);
  const ready = canvas !== undefined;
  // The canvas' size chooses the first arrangement; later changes of its size must not rearrange the drawing.
  const frame = useMemo(() => canvas, [ready, focus]);

  useEffect(() => {
    const root = tree?.keys().next().value;
    const path = focus ?? root;
    const state = tree === undefined || path === undefined ? undefined : stateAt(tree, path);
    if (state === undefined || path === undefined || frame === undefined) {
      setLaid(undefined);
      return;
    }
    // The rest of a drawing that nobody waits for any more would hold up the next one.
    const another = new AbortController();
    const { signal } = another;
    const engine = layoutInWorkers(signal);
    const aspect = Math.min(2.4, Math.max(0.6, frame.width / frame.height));
    const draw = (detail: Detail, onProgress?: (done: number, of: number) => void) =>
      layoutModel(engine, { state, path, collapsed, detail, aspect, signal, ...(onProgress === undefined ? {} : { onProgress }) }, memory);
    const keyOf = (detail: Detail) => `${root ?? ""} ${path} ${wanted} ${detail} ${collapsed.size}`;
    const take = (detail: Detail, drawing: Drawing) =>
      setLaid({ drawing, detail, shows: { focus, collapsed, detail: wanted }, asked: wanted !== "auto", key: keyOf(detail) });
    // The least detail is there first; more follows as long as it can be read.
    const show = async () => {
      const [first, ...more] = wanted === "auto" ? details : [wanted];
      if (first === undefined) return;
      let drawing = await draw(first, (done, of) => !signal.aborted && setProgress({ done, of }));
      if (signal.aborted) return;
      take(first, drawing);
      setProgress(undefined);
      for (const detail of more) {
        if (!readable(drawing, frame)) return;
        drawing = await draw(detail);
        if (signal.aborted || !readable(drawing, frame)) return;
        take(detail, drawing);
      }
    };
    setBusy(true);
    void show()
      .catch((error: unknown) => {
        if (signal.aborted) return;
        setProgress(undefined);
        setFailed(true);
        problem(error);
      })
      .finally(() => !signal.aborted && setBusy(false));
    return () => {
      another.abort();
      setBusy(false);
      setProgress(undefined);
      setFailed(false);
    };
  }, [tree, focus, collapsed, wanted, frame]);
  return { laid, progress, failed, busy };
}
