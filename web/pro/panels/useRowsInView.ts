// Which rows of a long list are in view, in the element that scrolls it.
import { useEffect, useState, type RefObject } from "react";
import { rowsBetween } from "../../shared/model/treeRows";

interface Rows {
  readonly first: number;
  readonly end: number;
}

/** `scroller`: a selector of the element that scrolls the list. All rows have this height [px]. */
export function useRowsInView(list: RefObject<HTMLElement | null>, scroller: string, count: number, height: number): Rows {
  const [rows, setRows] = useState<Rows>({ first: 0, end: 0 });
  useEffect(() => {
    const element = list.current;
    const frame = element?.closest<HTMLElement>(scroller);
    if (element === null || frame === null || frame === undefined) return;
    const measure = () => {
      const [inner, outer] = [element.getBoundingClientRect(), frame.getBoundingClientRect()];
      const next = rowsBetween(count, height, Math.max(outer.top, 0) - inner.top, Math.min(outer.bottom, innerHeight) - inner.top);
      setRows((before) => (before.first === next.first && before.end === next.end ? before : next));
    };
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(frame);
    // Also where the page itself scrolls.
    addEventListener("scroll", measure, { capture: true, passive: true });
    return () => {
      observer.disconnect();
      removeEventListener("scroll", measure, { capture: true });
    };
  }, [list, scroller, count, height]);
  return rows;
}
