// Rows of one height in a list that draws those in view: scrolling to one, and giving it the focus.
import { useEffect, useRef, type RefObject } from "react";

/** Scrolls the element of this selector, in which the list is, so that the row is in view, with `margin` rows beside it. */
export function showRow(list: HTMLElement | null, scroller: string, index: number, height: number, margin = 0): void {
  const frame = list?.closest(scroller);
  if (list === null || frame === null || frame === undefined) return;
  const top = list.getBoundingClientRect().top + index * height;
  const outer = frame.getBoundingClientRect();
  if (top < outer.top) frame.scrollTop += top - outer.top - margin * height;
  else if (top + height > outer.bottom) frame.scrollTop += top + (1 + margin) * height - outer.bottom;
}

/** A function that gives the focus to the element of a selector in the list: at once, or when it comes into the page. */
export function useFocusWhenShown(list: RefObject<HTMLElement | null>): (selector: string) => void {
  const wantedRef = useRef<string>(undefined);
  useEffect(() => {
    const element = wantedRef.current === undefined ? null : list.current?.querySelector<HTMLElement>(wantedRef.current);
    if (element === null || element === undefined) return;
    wantedRef.current = undefined;
    element.focus({ preventScroll: true });
  });
  return (selector) => {
    wantedRef.current = selector;
  };
}
