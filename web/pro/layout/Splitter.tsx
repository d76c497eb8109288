// The border of a panel: dragged by mouse or finger, moved by arrows, Home and End; a double click gives the usual size.
import { useEffect, useState, type KeyboardEvent, type PointerEvent } from "react";
import { boundsOf, panelShapes, shownSizes, sizeByKey, type FoldedPanel, type PanelName } from "../../shared/layout/panels";
import { setSize, panelsNow, toggleFolded, usePanels, windowNow } from "./panels";

interface Props {
  readonly panel: PanelName;
  /** On which side of the panel it lies: there a drag makes the panel larger. */
  readonly at: "left" | "right" | "top";
  /** Enter folds the panel away, or brings it back. */
  readonly folds?: FoldedPanel;
}

const kGrows = { left: "ArrowLeft", right: "ArrowRight", top: "ArrowUp" } as const;

function useWindow() {
  const [window, setWindow] = useState(windowNow);
  useEffect(() => {
    const measure = () => setWindow(windowNow());
    addEventListener("resize", measure);
    return () => removeEventListener("resize", measure);
  }, []);
  return window;
}

/** How far the pointer has moved in the direction that makes the panel larger. */
const grown = (at: Props["at"], from: PointerEvent, to: globalThis.PointerEvent): number =>
  at === "top" ? from.clientY - to.clientY : at === "left" ? from.clientX - to.clientX : to.clientX - from.clientX;

export function Splitter({ panel, at, folds }: Props) {
  const panels = usePanels();
  const window = useWindow();
  const { column, title } = panelShapes[panel];
  const bounds = boundsOf(panel, panels, window);
  const isFolded = folds !== undefined && panels.folded.has(folds);
  const size = isFolded ? 0 : shownSizes(panels, window)[panel];
  const drag = (pressed: PointerEvent<HTMLElement>) => {
    if (pressed.button !== 0 || isFolded) return;
    const { currentTarget: handle, pointerId } = pressed;
    const begun = panelsNow().sizes[panel];
    const stop = new AbortController();
    const move = (event: globalThis.PointerEvent) => {
      const { least, most } = boundsOf(panel, panelsNow(), windowNow());
      setSize(panel, Math.round(Math.max(least, Math.min(most, size + grown(at, pressed, event)))));
    };
    const giveUp = (event: globalThis.KeyboardEvent) => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      setSize(panel, begun);
      stop.abort();
    };
    handle.setPointerCapture(pointerId);
    handle.addEventListener("pointermove", move, { signal: stop.signal });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) handle.addEventListener(end, () => stop.abort(), { signal: stop.signal });
    addEventListener("keydown", giveUp, { capture: true, signal: stop.signal });
  };
  const press = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const next = isFolded ? undefined : sizeByKey(size, event.key, event.shiftKey, kGrows[at], bounds);
    if (next !== undefined) setSize(panel, next);
    else if (event.key === "Enter" && folds !== undefined) toggleFolded(folds);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div
      role="separator"
      className={`splitter splitter-${panel.replace("_", "-")} ${column ? "is-column" : "is-row"}`}
      tabIndex={0}
      aria-label={title}
      aria-orientation={column ? "vertical" : "horizontal"}
      aria-valuenow={size}
      aria-valuemin={isFolded ? 0 : bounds.least}
      aria-valuemax={bounds.most}
      aria-valuetext={isFolded ? "folded away" : `${size} pixels`}
      title={`${title}: drag, or arrow keys; double click for the usual size${folds === undefined ? "" : "; Enter folds"}`}
      onPointerDown={drag}
      onDoubleClick={() => setSize(panel, undefined)}
      onKeyDown={press}
    />
  );
}
