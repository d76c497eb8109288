// The cell beside the task: a small 3D view that can be put away.
import { lazy, Suspense } from "react";
import { useView, view } from "../client";

const CellView = lazy(() => import("./CellView").then(({ CellView }) => ({ default: CellView })));

export function CellInset() {
  const shown = useView((v) => v.inset);
  if (!shown) return null;
  return (
    <div className="cell-inset">
      <Suspense fallback={null}>
        <CellView />
      </Suspense>
      <button type="button" aria-label="Close the cell view" onClick={() => view.dispatch({ type: "inset", shown: false })}>
        ✕
      </button>
    </div>
  );
}
