// What comes by itself while the robot is moved by hand. It has a place that is there from the first, and what is longer lies over the page:
// no button that moves the arm goes from under a finger whose person looks at the arm.
import type { ReactNode } from "react";
import { createStore, useSelected } from "../page/store";

const place = createStore<HTMLElement | undefined, HTMLElement | undefined>(undefined, (_, next) => next);

/** Where the line of the controls puts what comes by itself; nothing: it keeps that, as there are no such notes, or they are folded away. */
export const useNotesPlace = (): HTMLElement | undefined => useSelected(place, (now) => now);

/** `bar`: within the notes, which have their height even if they are empty, but none where they are not drawn. */
function lend(bar: HTMLElement): () => void {
  const notes = bar.closest<HTMLElement>(".hand-notes") ?? bar;
  const take = () => {
    if (place.get() === bar) place.dispatch(undefined);
  };
  const look = () => (notes.offsetHeight > 0 ? place.dispatch(bar) : take());
  look();
  const watch = new ResizeObserver(look);
  watch.observe(notes);
  return () => {
    watch.disconnect();
    take();
  };
}

const lent = (bar: HTMLElement | null): (() => void) | undefined => (bar === null ? undefined : lend(bar));

interface Props {
  /** Why nothing moves; empty: nothing is in the way. */
  readonly said: string;
  readonly children?: ReactNode;
}

export function HandNotes({ said, children }: Props) {
  return (
    <div className="hand-notes">
      <div>
        <p className="hand-said" role="status">
          {said}
        </p>
        {children}
        <div ref={lent} className="hand-bar" />
      </div>
    </div>
  );
}
