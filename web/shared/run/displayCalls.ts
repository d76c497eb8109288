// The calls of a display: which of them a person answers, and their arguments (services/display/README.md).
import type { Call } from "../../generated/messages";
import type { JsonValue } from "../json";

/** Places of `display` among the arguments of the operations that a person answers. */
const kAsking: ReadonlyMap<string, number> = new Map([["ask", 2], ["choose", 2], ["ask_number", 5]]);
/** And of those that show something. */
const kShowing: ReadonlyMap<string, number> = new Map([["show_text", 2], ["show_image", 3], ["show_progress", 2]]);

export const isAsking = (operation: string): boolean => kAsking.has(operation);
export const isShowing = (operation: string): boolean => kShowing.has(operation);

/** An argument by its name or its place. */
export const argumentOf = ({ args, kwargs }: Call, name: string, place: number): JsonValue | undefined => kwargs[name] ?? args[place];

export function textArgument(call: Call, name: string, place: number): string | undefined {
  const value = argumentOf(call, name, place);
  return typeof value === "string" ? value : undefined;
}

/** The displays that a call is for: one by its name, those at a place by `@` and its name, or `all`. */
export const displayOf = (call: Call): string => textArgument(call, "display", kAsking.get(call.operation) ?? kShowing.get(call.operation) ?? 0) ?? "all";

/** The place that such a text names; undefined: it names none. */
export const placeOf = (display: string): string | undefined => (display.startsWith("@") ? display.slice(1) : undefined);

/** As people read it. */
export function displaysText(display: string): string {
  const place = placeOf(display);
  if (place !== undefined) return `the displays at ${place}`;
  return display === "all" ? "every display" : `the display ${display}`;
}

/** The address of the page that is such a display (web/display). */
export function displayAddress(display: string): string {
  const place = placeOf(display);
  if (place !== undefined) return `/display/?place=${encodeURIComponent(place)}`;
  return display === "all" ? "/display/" : `/display/?name=${encodeURIComponent(display)}`;
}

/** The name of the display as which the expert page shows and answers what all displays show, or those at a place. */
export const kOwnDisplay = "expert-page";

/** The one that the expert page becomes to show it, at the place that is named. */
export const ownDisplayFor = (display: string): string => (display === "all" || placeOf(display) !== undefined ? kOwnDisplay : display);
