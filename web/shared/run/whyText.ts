// The headline of an explanation, and the word for a truth value.
import type { Truth, Why } from "../messages/why";

export function truthText(value: Truth): "true" | "false" | "unknown" {
  return value === null ? "unknown" : value ? "true" : "false";
}

export function whyHeadline(why: Why): string {
  if (why.active) return "This port has fired";
  if (!why.stateActive) return "Cannot fire: its state is not active";
  if (why.value === true) return why.held === undefined ? "Fires in the next micro step" : `Held back by ${why.held}`;
  return "Does not fire";
}
