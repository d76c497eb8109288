// The legend over the drawing or the cell: it stays while one works, until it is closed by its button or Esc.
import { useEffect, useRef } from "react";
import { cellLegend, drawingLegend } from "../../../shared/help/legend";
import { createStore, useSelected } from "../../../page/store";
import { LegendLists } from "./LegendLists";

const store = createStore<boolean, boolean>(false, (_, next) => next);

export const useLegend = (): boolean => useSelected(store, (shown) => shown);
export const showLegend = (shown: boolean): void => store.dispatch(shown);

export const kLegend = "legend";

/** `about`: its signs come first. */
export function Legend({ about }: { readonly about: "drawing" | "cell" }) {
  const shown = useLegend();
  return shown ? <Shown about={about} /> : null;
}

function Shown({ about }: { readonly about: "drawing" | "cell" }) {
  const panel = useRef<HTMLElement>(null);
  useEffect(() => {
    const before = document.activeElement;
    panel.current?.focus({ preventScroll: true });
    return () => {
      if (before instanceof HTMLElement) before.focus({ preventScroll: true });
    };
  }, []);
  return (
    <section
      id={kLegend}
      className="legend"
      aria-label="Legend"
      tabIndex={-1}
      ref={panel}
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        showLegend(false);
      }}
    >
      <header>
        <h2>Legend</h2>
        <button type="button" aria-label="Close the legend" title="Close (Esc)" onClick={() => showLegend(false)}>
          ✕
        </button>
      </header>
      <LegendLists groups={about === "cell" ? cellLegend : [...drawingLegend, ...cellLegend]} />
    </section>
  );
}
