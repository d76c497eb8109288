// A run that waits for a person: its call of a display that is not answered yet, with the question in words.
import type { Call, Core, HostedService, PendingCall, TraceStep } from "../../generated/messages";
import type { JsonValue } from "../json";
import type { RcmDocument } from "../model/model";
import { callsOf } from "../orchestration/calls";

/** What can be answered: one of these texts, or a number of a range. */
export type Answers =
  | { readonly buttons: readonly string[] }
  | { readonly number: { readonly min: number; readonly max: number; readonly unit: string; readonly initial: number | undefined } };

export interface PersonWait {
  /** As in svc.<key>. */
  readonly service: string;
  readonly operation: string;
  /** Of its core; nothing: the server itself has called. */
  readonly call: number | undefined;
  /** Nothing, if the step that asked is not here. */
  readonly question: string | undefined;
  /** Nothing, as before. */
  readonly answers: Answers | undefined;
  /** The displays that show it: one by its name, or `all`. */
  readonly display: string;
}

/** The operations of a display that a person answers, and the place of `display` among their arguments (services/display/README.md). */
const kAsking: ReadonlyMap<string, number> = new Map([["ask", 2], ["choose", 2], ["ask_number", 5]]);

const textOf = (value: JsonValue | undefined): string | undefined => (typeof value === "string" ? value : undefined);

const numberOf = (value: JsonValue | undefined): number | undefined => (typeof value === "number" ? value : undefined);

/** The answers that a call offers, by its arguments (services/display/README.md). */
function answersOf(operation: string, { args, kwargs }: Call): Answers | undefined {
  const argument = (name: string, place: number): JsonValue | undefined => kwargs[name] ?? args[place];
  if (operation === "ask_number") {
    const [min, max] = [numberOf(argument("min", 1)), numberOf(argument("max", 2))];
    return min === undefined || max === undefined ? undefined : { number: { min, max, unit: textOf(argument("unit", 3)) ?? "", initial: numberOf(argument("initial", 4)) } };
  }
  const texts = operation === "choose" ? argument("choices", 1) : (argument("buttons", 1) ?? ["OK"]);
  return Array.isArray(texts) ? { buttons: texts.filter((text) => typeof text === "string") } : undefined;
}

function waitOf(service: string, { operation, core_call: number }: Pick<PendingCall, "operation" | "core_call">, call: Call | undefined): PersonWait {
  const display = textOf(call?.kwargs["display"]) ?? textOf(call?.args[kAsking.get(operation) ?? 0]) ?? "all";
  return { service, operation, call: number, question: textOf(call?.kwargs["question"]) ?? textOf(call?.args[0]), answers: call && answersOf(operation, call), display };
}

const callIn = (steps: readonly TraceStep[], service: string, number: number | undefined): Call | undefined =>
  steps.flatMap(({ calls }) => calls).filter((each) => each.service === service && each.call === number).at(-1);

const known = new WeakMap<RcmDocument, boolean>();

/** Whether a task may ask a person something. */
export function asksPeople(model: RcmDocument): boolean {
  const before = known.get(model);
  if (before !== undefined) return before;
  const asks = callsOf(model.root).some(({ operation }) => kAsking.has(operation));
  known.set(model, asks);
  return asks;
}

/** So many macro steps are looked through for the one that asked, in parts. */
const kLooked = 1000;
const kPart = 50;

/** The macro step that asked, looked for from the step `last` back: the page may not have had it, or not any more. */
export async function stepThatAsked({ service, call }: Pick<PersonWait, "service" | "call">, last: number, load: (from: number, to: number) => Promise<readonly TraceStep[]>): Promise<TraceStep | undefined> {
  for (let to = last; to > Math.max(0, last - kLooked); to -= kPart) {
    const steps = await load(Math.max(1, to - kPart + 1), to);
    const found = steps.find((step) => callIn([step], service, call) !== undefined);
    if (found !== undefined) return found;
  }
  return undefined;
}

/** The oldest question of this core that nobody has answered; nothing if it waits for no person. */
export function waitingForPerson(core: Core | undefined, services: readonly HostedService[], steps: readonly TraceStep[]): PersonWait | undefined {
  if (core?.status !== "running") return undefined;
  for (const { key, type, pending } of services) {
    const asked = type === "display" ? pending.find((each) => each.core === core.id && kAsking.has(each.operation)) : undefined;
    if (asked === undefined) continue;
    return waitOf(key, asked, callIn(steps, key, asked.core_call));
  }
  return undefined;
}

/** The name of the display as which the expert page answers what all displays show. */
export const kOwnDisplay = "expert-page";

/** The address of the page that shows it (web/display). */
export const displayAddress = ({ display }: PersonWait): string => (display === "all" ? "/display/" : `/display/?name=${encodeURIComponent(display)}`);
