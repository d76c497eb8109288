// How often a loop repeats, in a few words.
import { endsOf, failuresThatEnd } from "../../shared/timeline/until";
import type { Step } from "../../shared/timeline/timeLine";
import { texts } from "../texts";

const t = texts.line;

/** `3 ×`, `for ever`, `until “The grid is full”`, or several of these; of another step nothing. */
export function repeatText(loop: Step): string {
  const value = loop.repeat?.value;
  if (value?.kind !== "constant" || typeof value.value !== "number") return "";
  const ends = [...endsOf(loop).filter(({ isChosen }) => isChosen).map(({ title }) => t.until(title)), ...failuresThatEnd(loop).map(({ title }) => t.untilItFails(title))];
  return [...(value.value > 0 ? [t.times(value.value)] : ends.length === 0 ? [t.forEver] : []), ...ends].join(t.or);
}
