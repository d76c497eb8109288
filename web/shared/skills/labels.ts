// The labels of parts that a field offers: what the camera sees now, what its service can find, and what documents name.
import type { HostedService } from "../../generated/messages";
import { entryOf, isObject, type JsonValue } from "../json";

/** The type of a service that finds parts (services/recognition). */
const kRecognition = "ObjectRecognition";

/** The key of the service that finds parts; nothing: none is there now. */
export const recognitionOf = (services: readonly Pick<HostedService, "key" | "type" | "available">[]): string | undefined => services.find(({ type, available }) => type === kRecognition && available)?.key;

const textsIn = (value: JsonValue | undefined): readonly string[] => (Array.isArray(value) ? value.filter((item: unknown): item is string => typeof item === "string") : []);
const sorted = (texts: readonly string[]): readonly string[] => [...new Set(texts)].filter((text) => text !== "").sort((a, b) => a.localeCompare(b));

/** The labels in a response to `look`. */
export function labelsSeen(response: JsonValue): readonly string[] {
  const objects = isObject(response) ? entryOf(response, "objects") : undefined;
  return textsIn(Array.isArray(objects) ? objects.map((each: JsonValue) => (isObject(each) ? (entryOf(each, "label") ?? null) : null)) : []);
}

/** The labels in a response to `labels`. */
export const labelsKnown = (response: JsonValue): readonly string[] => textsIn(response);

export interface OfferedLabels {
  /** Seen now. */
  readonly seen: readonly string[];
  /** Those that the service can find, then those that documents name. */
  readonly others: readonly string[];
}

/** Each label once, at the first place where it belongs. */
export function offeredLabels(seen: readonly string[], known: readonly string[], named: readonly string[]): OfferedLabels {
  const first = sorted(seen);
  const second = sorted(known).filter((label) => !first.includes(label));
  const third = sorted(named).filter((label) => !first.includes(label) && !second.includes(label));
  return { seen: first, others: [...second, ...third] };
}
