// The cell beside the task: below the properties or in a half of the workspace, if there is room; from there also as the whole page, or in a
// window of its own.
import { Suspense, useSyncExternalStore } from "react";
import { addressWith } from "../../shared/session/address";
import type { CellPlace } from "../../shared/layout/panels";
import { afterFirstDrawing } from "../canvas/firstDrawing";
import { useSession, view } from "../client";
import { hideCell, showCell, useCellPlace } from "../layout/panels";
import { Splitter } from "../layout/Splitter";
import { lateCell } from "./lateCell";

const CellView = lateCell(afterFirstDrawing);

const kRoom: Readonly<Record<CellPlace, MediaQueryList>> = {
  column: matchMedia("(min-width: 1081px) and (min-height: 640px)"),
  half: matchMedia("(min-width: 761px)"),
};

function useRoom(place: CellPlace): boolean {
  const query = kRoom[place];
  const listen = (listener: () => void) => {
    query.addEventListener("change", listener);
    return () => query.removeEventListener("change", listener);
  };
  return useSyncExternalStore(listen, () => query.matches);
}

export function CellDock({ at }: { readonly at: CellPlace }) {
  const place = useCellPlace();
  const hasCell = useSession((s) => s.cell);
  const roomy = useRoom(at);
  if (place !== at || !hasCell || !roomy) return null;
  return (
    <section className={`cell-dock is-${at}`} aria-label="Beside the task">
      {at === "column" ? <Splitter panel="cell" at="top" /> : <Splitter panel="cell_half" at="left" />}
      <Suspense fallback={null}>
        <CellView />
      </Suspense>
      <DockTools at={at} />
    </section>
  );
}

function DockTools({ at }: { readonly at: CellPlace }) {
  return (
    <div className="dock-tools" role="group" aria-label="Place of the cell view">
      {at === "half" ? (
        <button type="button" aria-label="Below the properties" title="Show the cell below the properties" onClick={() => showCell("column")} className="dock-column" />
      ) : (
        <button type="button" aria-label="Beside the drawing" title="Show the cell in a half of the workspace" onClick={() => showCell("half")} className="dock-side" />
      )}
      <button type="button" aria-label="As the whole page" title="Show the cell as the whole page" onClick={() => view.dispatch({ type: "page", page: "cell" })} className="dock-whole" />
      <button type="button" aria-label="In a window of its own" title="Show the cell in a window of its own" onClick={() => window.open(addressWith(location.search, { page: "cell" }), "_blank", "noopener")} className="dock-window" />
      <button type="button" aria-label="Close the cell view" title="Close the cell view" onClick={hideCell}>
        ✕
      </button>
    </div>
  );
}
