// The drawing of what the view shows, laid out anew when the model, the focus, what is collapsed or the detail changes.
import { useEffect, useMemo, useState } from "react";
import type { Drawing } from "../../shared/drawing/drawing";
import type { LayoutEngine } from "../../shared/drawing/elk";
import { readable } from "../../shared/drawing/fit";
import { layoutModel } from "../../shared/drawing/layout";
import { details, type Detail, type Size } from "../../shared/drawing/measure";
import { buildTree, stateAt, type ModelTree } from "../../shared/model/modelTree";
import { useSession, useView } from "../client";
import { layoutInWorker } from "./layoutEngine";

export interface Laid {
  readonly drawing: Drawing;
  readonly detail: Detail;
  /** The detail was asked for, so it must be large enough to be read at first. */
  readonly asked: boolean;
  /** What the canvas fits itself to: changes with the model, the focus and the detail. */
  readonly key: string;
}

export function useTree(): ModelTree | undefined {
  const model = useSession((session) => session.model);
  return useMemo(() => (model === undefined ? undefined : buildTree(model.root)), [model]);
}

export function useDrawing(tree: ModelTree | undefined, canvas: Size | undefined): Laid | undefined {
  const focus = useView((view) => view.focus);
  const collapsed = useView((view) => view.collapsed);
  const wanted = useView((view) => view.detail);
  const [laid, setLaid] = useState<Laid>();
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
    let current = true;
    const aspect = Math.min(2.4, Math.max(0.6, frame.width / frame.height));
    // The rest of a drawing that nobody waits for any more would hold up the next one.
    const engine: LayoutEngine = (graph) => (current ? layoutInWorker(graph) : Promise.reject(new Error("another drawing is wanted")));
    const draw = (detail: Detail) => layoutModel(engine, { state, path, collapsed, detail, aspect });
    const keyOf = (detail: Detail) => `${root ?? ""} ${path} ${wanted} ${detail} ${collapsed.size}`;
    // The least detail is there first; more follows as long as it can be read.
    const show = async () => {
      for (const detail of wanted === "auto" ? details : [wanted]) {
        const drawing = await draw(detail);
        if (!current || (detail !== "slim" && wanted === "auto" && !readable(drawing, frame))) return;
        setLaid({ drawing, detail, asked: wanted !== "auto", key: keyOf(detail) });
      }
    };
    show().catch((error: unknown) => {
      if (current) throw error;
    });
    return () => {
      current = false;
    };
  }, [tree, focus, collapsed, wanted, frame]);
  return laid;
}
