// The headline of an explanation, and the word for a truth value.
import { valueText } from "../model/describe";
import type { Truth, Why, WhyAtom } from "../../generated/messages";

export function truthText(value: Truth): "true" | "false" | "unknown" {
  return value === null ? "unknown" : value ? "true" : "false";
}

/** Whether an atom is made of constants alone: it reads nothing that could change. */
function isConstant(atom: WhyAtom): boolean {
  return (atom.reads ?? []).length === 0 && (atom.requires ?? []).length === 0 && !atom.service;
}

/** That a condition reads nothing, and what follows from it; nothing where one of its atoms reads something. */
export function constantText(why: Why): string | undefined {
  if (why.atoms.length === 0 || !why.atoms.every(isConstant)) return undefined;
  const cause = "The condition is constant: it reads no parameter, result, variable, port or service data";
  if (why.value === null) return `${cause}, so its evaluation fails every time.`;
  return why.value
    ? `${cause}, so it is always true. Once its state is active, the port needs nothing more to fire.`
    : `${cause}, so it is always false. The port can never fire.`;
}

export function whyHeadline(why: Why): string {
  if (why.active) return "This port has fired";
  if (why.value === false && constantText(why) !== undefined) return "Never fires";
  if (!why.state_active) return "Cannot fire: its state is not active";
  if (why.value === true) return why.held === undefined ? "Fires in the next micro step" : `Held back by ${why.held}`;
  return "Does not fire";
}

/** The sentences that explain it. Of constants the server's own says what would change, which they cannot. */
export function whySentences(why: Why): readonly string[] {
  const constant = constantText(why);
  if (constant === undefined) return [why.reason];
  return why.active || !why.state_active || why.value === true ? [why.reason, constant] : [constant];
}

/** What the change of an atom would do to the port, if it would do anything: nothing, where its state is not active or it has fired. */
export function atomAdvice(why: Why, atom: WhyAtom): string | undefined {
  if (why.active || !why.state_active || (atom.reads ?? []).length === 0) return undefined;
  if (!atom.blocks && atom.together !== true) return undefined;
  const become = atom.wanted === undefined ? "a change" : `becoming ${truthText(atom.wanted)}`;
  return atom.blocks ? `${become} alone would fire this port` : `${become} would fire it, with the others marked so`;
}

/** A text of the server in pieces: what stands between backticks is code. */
export function codePieces(text: string): readonly { readonly code: boolean; readonly text: string }[] {
  return text.split("`").map((piece, i) => ({ code: i % 2 === 1, text: piece }));
}

/** What an atom reads, with the values that are there. */
export function readsText(atom: WhyAtom): string | undefined {
  if (isConstant(atom)) return "a constant: it reads nothing";
  if (atom.reads === undefined || atom.reads.length === 0) return undefined;
  return atom.reads.map((read) => `${read.text} ${read.value === undefined ? "has no value yet" : `is ${valueText(read.value)}`}`).join(", ");
}
