// Telling the user above the drawing, not in a dialog.
import { editing } from "./editing";

/** Why something cannot be done. */
export const refuse = (reason: string): void => editing.dispatch({ type: "said", tone: "refused", text: `Not done: ${reason}.` });

/** That something was done; it disappears by itself. */
export const tellDone = (text: string): void => editing.dispatch({ type: "said", tone: "done", text });
