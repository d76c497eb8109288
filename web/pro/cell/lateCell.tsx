// The 3D view, whose code is loaded when it is needed: by then the server may be lost, and the page goes on without it.
import { lazy } from "react";

function MissingCell() {
  return <p className="cell-note">The cell cannot be shown: its code could not be loaded. Load the page again.</p>;
}

/** `first`: what is waited for before. */
export const lateCell = (first: () => Promise<void>) =>
  lazy(() =>
    first()
      .then(() => import("./CellView"))
      .then(({ CellView }) => ({ default: CellView }))
      .catch(() => ({ default: MissingCell })),
  );
