// The texts of an explanation (api/schemas/why.json).
import { valueText } from "../model/describe";
import type { Truth, Why, WhyAtom } from "../../generated/messages";

export function truthText(value: Truth): "true" | "false" | "unknown" {
  return value === null ? "unknown" : value ? "true" : "false";
}

/** Whether an atom is constant: it reads nothing. */
function isConstant(atom: WhyAtom): boolean {
  return (atom.reads ?? []).length === 0 && (atom.requires ?? []).length === 0 && !atom.service;
}

/** The explanation of a constant condition; undefined if one of its atoms reads something. */
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

/** The sentences that explain the port. The reason of the server names atoms that would have to change, so it is left out for constants. */
export function whySentences(why: Why): readonly string[] {
  const constant = constantText(why);
  if (constant === undefined) return [why.reason];
  return why.active || !why.state_active || why.value === true ? [why.reason, constant] : [constant];
}

/** The effect of a change of an atom on the port. None if the port has fired or its state is not active. */
export function atomAdvice(why: Why, atom: WhyAtom): string | undefined {
  if (why.active || !why.state_active || (atom.reads ?? []).length === 0) return undefined;
  if (!atom.blocks && atom.together !== true) return undefined;
  const become = atom.wanted === undefined ? "a change" : `becoming ${truthText(atom.wanted)}`;
  return atom.blocks ? `${become} alone would fire this port` : `${become} would fire it, with the others marked so`;
}

/** Splits a text of the server: the parts between backticks are code. */
export function codePieces(text: string): readonly { readonly code: boolean; readonly text: string }[] {
  return text.split("`").map((piece, i) => ({ code: i % 2 === 1, text: piece }));
}

/** The names that an atom reads, with their values. */
export function readsText(atom: WhyAtom): string | undefined {
  if (isConstant(atom)) return "a constant: it reads nothing";
  if (atom.reads === undefined || atom.reads.length === 0) return undefined;
  return atom.reads.map((read) => `${read.text} ${read.value === undefined ? "has no value yet" : `is ${valueText(read.value)}`}`).join(", ");
}
