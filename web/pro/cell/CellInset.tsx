// The cell beside the task: a small 3D view below the properties, if there is room.
import { lazy, Suspense, useSyncExternalStore } from "react";
import { useSession, useView, view } from "../client";

const CellView = lazy(() => import("./CellView").then(({ CellView }) => ({ default: CellView })));

const wide = matchMedia("(min-width: 1081px) and (min-height: 640px)");

function listenToWidth(listener: () => void): () => void {
  wide.addEventListener("change", listener);
  return () => wide.removeEventListener("change", listener);
}

export function CellInset() {
  const wanted = useView((v) => v.inset);
  const hasCell = useSession((s) => s.cell);
  const roomy = useSyncExternalStore(listenToWidth, () => wide.matches);
  if (!wanted || !hasCell || !roomy) return null;
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
