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

/** What the change of an atom would do to the port, if it would do anything: nothing, where its state is not active or it has fired. */
export function atomAdvice(why: Why, atom: WhyAtom): string | undefined {
  if (why.active || !why.stateActive || atom.reads.length === 0) return undefined;
  if (!atom.blocks && !atom.together) return undefined;
  const become = atom.wanted === undefined ? "a change" : `becoming ${truthText(atom.wanted)}`;
  return atom.blocks ? `${become} alone would fire this port` : `${become} would fire it, with the others marked so`;
}

/** A text of the server in pieces: what stands between backticks is code. */
export function codePieces(text: string): readonly { readonly code: boolean; readonly text: string }[] {
  return text.split("`").map((piece, i) => ({ code: i % 2 === 1, text: piece }));
}

/** What an atom reads, with the values that are there. */
export function readsText(atom: WhyAtom): string | undefined {
  if (atom.reads.length === 0) return undefined;
  return atom.reads.map((read) => `${read.text} ${read.value === undefined ? "has no value yet" : `is ${valueText(read.value)}`}`).join(", ");
}
