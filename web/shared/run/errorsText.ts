// How many errors there are, in words.
import { counted } from "../counted";

/** How many errors the server lists (errors.json); it counts one more if there are more. */
const MOST = 200;

/** "1 error", "3 errors", "more than 200 errors". */
export const errorsText = (count: number): string => (count > MOST ? `more than ${MOST} errors` : counted(count, "error"));

/** What is listed of errors, as their number: `more` says that there are more. */
export const countErrors = (errors: readonly unknown[], more: true | undefined): number => errors.length + (more ? 1 : 0);
