// What is drawn over the page while something is dragged.
import { createStore, useSelected } from "../../../page/store";
import type { ScreenPoint } from "../prompt";

export interface DragShown {
  /** A line from a port or barrier to the pointer. */
  readonly line?: { readonly from: ScreenPoint; readonly to: ScreenPoint };
  /** A rubber band. */
  readonly band?: DOMRect;
  /** What it would be dropped on. */
  readonly target?: DOMRect | undefined;
  /** What it cannot be dropped on. */
  readonly dimmed?: readonly DOMRect[];
  /** Beside the pointer: what is dragged, or why it cannot be dropped. */
  readonly text?: { readonly at: ScreenPoint; readonly text: string; readonly refused: boolean } | undefined;
}

const store = createStore<DragShown | undefined, DragShown | undefined>(undefined, (_, shown) => shown);

export const showDrag = (shown: DragShown | undefined): void => store.dispatch(shown);
export const useDragShown = (): DragShown | undefined => useSelected(store, (shown) => shown);
