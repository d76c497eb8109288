// The language of the page.
import { en } from "./en";

/** What a language has to have. */
export type Texts = typeof en;

export const texts: Texts = en;
