// What the canvas can be asked: how much it writes, and to collapse or expand everything.
import type { Detail } from "../../shared/drawing/measure";
import type { ModelTree } from "../../shared/model/modelTree";
import { useView, view } from "../client";

export function CanvasTools({ tree, detail }: { readonly tree: ModelTree; readonly detail: Detail }) {
  const collapsed = useView((v) => v.collapsed.size > 0);
  const composites = [...tree.values()].filter((entry) => entry.depth > 0 && entry.children.length > 0).map((entry) => entry.path);
  return (
    <div className="canvas-tools" role="toolbar" aria-label="Drawing">
      <button
        type="button"
        aria-pressed={detail === "full"}
        title="Write parameters, functions and conditions into the drawing"
        onClick={() => view.dispatch({ type: "detail", detail: detail === "full" ? "slim" : "full" })}
      >
        Details
      </button>
      {composites.length > 0 && (
        <button type="button" onClick={() => view.dispatch(collapsed ? { type: "expand_all" } : { type: "collapse_all", paths: composites })}>
          {collapsed ? "Expand all" : "Collapse all"}
        </button>
      )}
    </div>
  );
}
