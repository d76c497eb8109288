// The headline of an explanation, and the word for a truth value.
import { valueText } from "../model/describe";
import type { Truth, Why, WhyAtom } from "../messages/why";

export function truthText(value: Truth): "true" | "false" | "unknown" {
  return value === null ? "unknown" : value ? "true" : "false";
}

export function whyHeadline(why: Why): string {
  if (why.active) return "This port has fired";
  if (!why.stateActive) return "Cannot fire: its state is not active";
  if (why.value === true) return why.held === undefined ? "Fires in the next micro step" : `Held back by ${why.held}`;
  return "Does not fire";
}

/** What the change of an atom would do to the port, if it would do anything. */
export function atomAdvice(atom: WhyAtom): string | undefined {
  if (!atom.blocks && !atom.together) return undefined;
  const become = atom.wanted === undefined ? "a change" : `becoming ${truthText(atom.wanted)}`;
  return atom.blocks ? `${become} alone would fire this port` : `${become} would fire it, with the others marked so`;
}

/** What an atom reads, with the values that are there. */
export function readsText(atom: WhyAtom): string | undefined {
  if (atom.reads.length === 0) return undefined;
  return atom.reads.map((read) => `${read.text} ${read.value === undefined ? "has no value yet" : `is ${valueText(read.value)}`}`).join(", ");
}
