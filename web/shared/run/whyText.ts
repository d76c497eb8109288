// The texts of an explanation (api/schemas/why.json).
import { valueText } from "../model/describe";
import type { Truth, WhyAction, WhyAtom, WhyParameter, WhyPort, WhyReads } from "../../generated/messages";

/** An explanation of a condition. */
export type WhyCondition = WhyPort | WhyAction;

const isPort = (why: WhyCondition): why is WhyPort => "port" in why;
/** What has happened needs nothing more. */
export const isDone = (why: WhyCondition): boolean => (isPort(why) ? why.active || why.forced === true : why.executed);

export function truthText(value: Truth): "true" | "false" | "unknown" {
  return value === null ? "unknown" : value ? "true" : "false";
}

/** Whether an atom is constant: it reads nothing. */
function isConstant(atom: WhyAtom): boolean {
  return (atom.reads ?? []).length === 0 && (atom.requires ?? []).length === 0 && !atom.service;
}

/** The explanation of a constant condition; undefined if one of its atoms reads something. */
export function constantText(why: WhyCondition): string | undefined {
  if (why.atoms.length === 0 || !why.atoms.every(isConstant)) return undefined;
  const cause = "The condition is constant: it reads no parameter, result, variable, port or service data";
  if (why.value === null) return `${cause}, so its evaluation fails every time.`;
  if (isPort(why)) return why.value ? `${cause}, so it is always true. Once its state is active, the port needs nothing more to fire.` : `${cause}, so it is always false. The port can never fire.`;
  return why.value ? `${cause}, so it is always true. Once its state is active, the action needs nothing more.` : `${cause}, so it is always false. The action is never executed.`;
}

const isNever = (why: WhyCondition): boolean => why.value === false && constantText(why) !== undefined;

function portHeadline(why: WhyPort): string {
  if (why.active) return "This port has fired";
  if (why.forced === true) return "Fires in the next micro step: somebody has forced it";
  if (isNever(why)) return "Never fires";
  if (!why.state_active) return "Cannot fire: its state is not active";
  if (why.value === true) return why.held === undefined ? "Fires in the next micro step" : `Held back by ${why.held}`;
  return "Does not fire";
}

function actionHeadline(why: WhyAction): string {
  if (why.executed) return "Executed in this macro step";
  if (isNever(why)) return "Never executed";
  if (!why.state_active) return "Not executed: its state is not active";
  if (why.held === "R19") return "Not executed again: it waits for something new";
  if (why.held === "R3") return "Not executed: its function reads what is not there yet";
  if (why.held === "R4") return "Its function ends in a fault";
  return why.value === true ? "Executed in the next micro step" : "Not executed";
}

export const whyHeadline = (why: WhyCondition): string => (isPort(why) ? portHeadline(why) : actionHeadline(why));

/** Of a parameter: what it would be given now, or was at its turn. */
export function parameterHeadline({ argument, expression, gives, state_active, turn }: WhyParameter): string {
  if (argument === true) return "Given with the start of the run";
  if (expression === undefined) return "A constant of the model";
  if (gives === undefined) return "Would have no value";
  if (turn === true) return `Its expression gave ${valueText(gives)}`;
  return state_active ? `The next activation would give it ${valueText(gives)}` : `An activation would give it ${valueText(gives)}`;
}

/** The sentences that explain a condition. The reason of the server names atoms that would have to change, so it is left out for constants. */
export function whySentences(why: WhyCondition): readonly string[] {
  const constant = constantText(why);
  if (constant === undefined) return [why.reason];
  return isDone(why) || !why.state_active || why.value === true ? [why.reason, constant] : [constant];
}

/** The effect of a change of an atom. None if it has happened, or its state is not active. */
export function atomAdvice(why: WhyCondition, atom: WhyAtom): string | undefined {
  if (isDone(why) || !why.state_active || (atom.reads ?? []).length === 0) return undefined;
  if (!atom.blocks && atom.together !== true) return undefined;
  const become = atom.wanted === undefined ? "a change" : `becoming ${truthText(atom.wanted)}`;
  const [would, it] = isPort(why) ? ["would fire", "this port"] : ["would execute", "this action"];
  return atom.blocks ? `${become} alone ${would} ${it}` : `${become} ${would} it, with the others marked so`;
}

/** Splits a text of the server: the parts between backticks are code. */
export function codePieces(text: string): readonly { readonly code: boolean; readonly text: string }[] {
  return text.split("`").map((piece, i) => ({ code: i % 2 === 1, text: piece }));
}

/** The names that an atom reads, with their values. */
export const readsText = (atom: WhyAtom): string | undefined => (isConstant(atom) ? "a constant: it reads nothing" : namesText(atom.reads));

/** Names that are read, with their values; nothing if there are none. */
export function namesText(reads: WhyReads | undefined): string | undefined {
  if (reads === undefined || reads.length === 0) return undefined;
  return reads.map((read) => `${read.text} ${read.value === undefined ? "has no value yet" : `is ${valueText(read.value)}`}`).join(", ");
}
