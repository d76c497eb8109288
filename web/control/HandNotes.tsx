// What comes by itself while the robot is moved by hand. It has a place that is there from the first, and what is longer lies over the page:
// no button that moves the arm goes from under a finger whose person looks at the arm.
import type { ReactNode } from "react";
import { createStore, useSelected } from "../page/store";

const place = createStore<HTMLElement | undefined, HTMLElement | undefined>(undefined, (_, next) => next);

/** Where the line of the controls puts what comes by itself; nothing: it keeps that. */
export const useNotesPlace = (): HTMLElement | undefined => useSelected(place, (now) => now);

function lend(element: HTMLElement | null): () => void {
  place.dispatch(element ?? undefined);
  return () => {
    if (place.get() === element) place.dispatch(undefined);
  };
}

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
        <div ref={lend} className="hand-bar" />
      </div>
    </div>
  );
}
