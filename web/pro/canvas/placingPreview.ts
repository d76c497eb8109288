// A drawing that is shown in place of another one while something in it is dragged, and until the next one is laid out.
import { createStore, useSelected } from "../../page/store";
import type { Laid } from "./useDrawing";

interface Preview {
  readonly of: Laid;
  readonly shown: Laid;
}

const preview = createStore<Preview | undefined, Preview | undefined>(undefined, (_, next) => next);

/** Shows `shown` where `of` would be; nothing: `of` itself again. */
export const showPreview = (of: Laid, shown: Laid | undefined): void => preview.dispatch(shown && { of, shown });

/** What is shown of a drawing that is laid out. */
export const usePreviewed = (laid: Laid | undefined): Laid | undefined => useSelected(preview, (now) => (now?.of === laid ? now?.shown : laid));

/** Whether a drawing is only shown until the next one is laid out. */
export const isPreview = (laid: Laid): boolean => preview.get()?.shown === laid;
