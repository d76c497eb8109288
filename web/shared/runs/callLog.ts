// The calls, responses, events and forced values of a run, one entry each, in their order: what a person looks through.
import type { Derivation, Input, TraceStep } from "../../generated/messages";
import type { Moment } from "../past/moment";
import { callText, inputText } from "../run/inputText";

export const kEntryKinds = ["call", "response", "event", "force", "run"] as const;
/** `run`: that it was started, edited or aborted. */
export type EntryKind = (typeof kEntryKinds)[number];

export interface RunEntry extends Moment {
  readonly kind: EntryKind;
  /** Its key; nothing: it is of no service. */
  readonly service: string | undefined;
  readonly text: string;
  /** What stands for several that follow each other: how many they are. */
  readonly count: number;
  /** Of an event, its name. */
  readonly event?: string;
}

export interface LoggedStep {
  readonly step: number;
  readonly entries: readonly RunEntry[];
}

export function inputEntry(input: Input, step: number): RunEntry {
  const entry = { step, micro: 0, count: 1, text: inputText(input) };
  switch (input.kind) {
    case "event":
      return { ...entry, kind: "event", service: input.service, event: input.event };
    case "response":
      return { ...entry, kind: "response", service: input.service };
    case "force":
      return { ...entry, kind: "force", service: undefined };
    default:
      return { ...entry, kind: "run", service: undefined };
  }
}

interface Place {
  readonly service: string;
  readonly operation: string;
  /** Micro steps that are done with it. */
  readonly micro: number;
}

const placesIn = ({ service, operation, premises }: Derivation, micro: number): readonly Place[] => [
  ...(service === undefined || operation === undefined ? [] : [{ service, operation, micro }]),
  ...premises.flatMap((each) => placesIn(each, micro)),
];

/** What arrived in a macro step, then what was called in it, with the micro steps of its derivation that made the calls. */
export function loggedStep({ step, input, micro, calls, first = 0 }: TraceStep): LoggedStep {
  const places = micro.flatMap((root, i) => placesIn(root, first + i + 1));
  let at = 0;
  const made = calls.map((call): RunEntry => {
    const found = places.findIndex(({ service, operation }, i) => i >= at && service === call.service && operation === call.operation);
    if (found >= 0) at = found + 1;
    // Safe operations are called after the last micro step.
    const done = places[found]?.micro ?? first + micro.length;
    return { step, micro: done, kind: "call", service: call.service, text: callText(call), count: 1 };
  });
  return { step, entries: [inputEntry(input, step), ...made] };
}

/** The same events that follow each other, without anything between them, are one entry, the last. */
export function folded(entries: readonly RunEntry[]): readonly RunEntry[] {
  const found: RunEntry[] = [];
  for (const entry of entries) {
    const before = found.at(-1);
    const isSame = before !== undefined && entry.event !== undefined && before.event === entry.event && before.service === entry.service;
    if (isSame) found[found.length - 1] = { ...entry, count: before.count + 1 };
    else found.push(entry);
  }
  return found;
}

export interface EntryFilter {
  /** Nothing: all. */
  readonly kind?: EntryKind | undefined;
  readonly service?: string | undefined;
  readonly text: string;
}

export function matchingEntries(entries: readonly RunEntry[], { kind, service, text }: EntryFilter): readonly RunEntry[] {
  const wanted = text.trim().toLowerCase();
  return entries.filter((entry) => (kind === undefined || entry.kind === kind) && (service === undefined || entry.service === service) && entry.text.toLowerCase().includes(wanted));
}

export const servicesOf = (entries: readonly RunEntry[]): readonly string[] => [...new Set(entries.flatMap(({ service }) => service ?? []))].sort();
