// Dragging the rows of a list by their handles.
import { useState, type PointerEvent, type RefObject } from "react";

interface Drag {
  readonly id: string;
  /** The position among the others at which it would be dropped. */
  readonly to: number;
}

const rowsIn = (list: HTMLElement | null): readonly HTMLElement[] => [...(list?.querySelectorAll<HTMLElement>(":scope > [data-row]") ?? [])];

const isBelow = (row: HTMLElement, y: number): boolean => {
  const { top, height } = row.getBoundingClientRect();
  return y > top + height / 2;
};

export function useRowDrag(list: RefObject<HTMLElement | null>, onMove: ((id: string, to: number) => void) | undefined) {
  const [drag, setDrag] = useState<Drag>();
  const others = (id: string) => rowsIn(list.current).filter((row) => row.dataset["row"] !== id);
  const placeAt = (id: string, y: number): number => others(id).filter((row) => isBelow(row, y)).length;

  const handlersOf = (id: string) => ({
    onPointerDown: (event: PointerEvent<HTMLElement>) => {
      if (event.button !== 0 || onMove === undefined) return;
      event.currentTarget.setPointerCapture(event.pointerId);
      setDrag({ id, to: placeAt(id, event.clientY) });
    },
    onPointerMove: (event: PointerEvent<HTMLElement>) => drag?.id === id && setDrag({ id, to: placeAt(id, event.clientY) }),
    onPointerUp: (event: PointerEvent<HTMLElement>) => {
      if (drag?.id !== id) return;
      setDrag(undefined);
      onMove?.(id, placeAt(id, event.clientY));
    },
    onLostPointerCapture: () => setDrag(undefined),
  });

  /** Where the row would be dropped is shown at its neighbours. */
  const classOf = (id: string): string => {
    if (drag === undefined) return "";
    if (drag.id === id) return "is-dragged";
    const rest = others(drag.id).map((row) => row.dataset["row"]);
    if (rest[drag.to] === id) return "is-drop-above";
    return drag.to === rest.length && rest.at(-1) === id ? "is-drop-below" : "";
  };
  return { handlersOf, classOf };
}
