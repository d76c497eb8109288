// A run that waits for a person: its call of a display that is not answered yet, with the question in words.
import type { Call, Core, HostedService, PendingCall, TraceStep } from "../../generated/messages";
import type { JsonValue } from "../json";
import { argumentOf, displayOf, isAsking, textArgument } from "./displayCalls";

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
  /** Nothing, if the call that asked is not here. */
  readonly question: string | undefined;
  /** Nothing, as before. */
  readonly answers: Answers | undefined;
  /** The displays that show it: one by its name, or `all`. */
  readonly display: string;
}

const numberOf = (value: JsonValue | undefined): number | undefined => (typeof value === "number" ? value : undefined);

/** The answers that a call offers, by its arguments. */
function answersOf(operation: string, call: Call): Answers | undefined {
  if (operation === "ask_number") {
    const [min, max] = [numberOf(argumentOf(call, "min", 1)), numberOf(argumentOf(call, "max", 2))];
    return min === undefined || max === undefined ? undefined : { number: { min, max, unit: textArgument(call, "unit", 3) ?? "", initial: numberOf(argumentOf(call, "initial", 4)) } };
  }
  const texts = operation === "choose" ? argumentOf(call, "choices", 1) : (argumentOf(call, "buttons", 1) ?? ["OK"]);
  return Array.isArray(texts) ? { buttons: texts.filter((text) => typeof text === "string") } : undefined;
}

function waitOf(service: string, { operation, core_call: number }: Pick<PendingCall, "operation" | "core_call">, call: Call | undefined): PersonWait {
  return { service, operation, call: number, question: call && textArgument(call, "question", 0), answers: call && answersOf(operation, call), display: call === undefined ? "all" : displayOf(call) };
}

const callIn = (calls: readonly Call[], service: string, number: number | undefined): Call | undefined =>
  calls.filter((each) => each.service === service && each.call === number).at(-1);

/** So many questions are kept, the last ones: more are not open at the same time. */
const kQuestions = 50;

/** The questions that a run has asked, with those among the calls that it has made now. */
export function withQuestions(known: readonly Call[], calls: readonly Call[]): readonly Call[] {
  const added = calls.filter(({ operation }) => isAsking(operation));
  return added.length === 0 ? known : [...known, ...added].slice(-kQuestions);
}

/** So many macro steps are looked through for the one that asked, in parts. */
const kLooked = 1000;
const kPart = 50;

/** The call that asked, looked for from the step `last` back: the page may not have had it, or not any more. */
export async function callThatAsked({ service, call }: Pick<PersonWait, "service" | "call">, last: number, load: (from: number, to: number) => Promise<readonly TraceStep[]>): Promise<Call | undefined> {
  for (let to = last; to > Math.max(0, last - kLooked); to -= kPart) {
    const steps = await load(Math.max(1, to - kPart + 1), to);
    const found = callIn(steps.flatMap(({ calls }) => calls), service, call);
    if (found !== undefined) return found;
  }
  return undefined;
}

/** The oldest question of this core that nobody has answered; nothing if it waits for no person. `questions`: that it has asked, as far as they are here. */
export function waitingForPerson(core: Core | undefined, services: readonly HostedService[], questions: readonly Call[]): PersonWait | undefined {
  if (core?.status !== "running") return undefined;
  for (const { key, type, pending } of services) {
    const asked = type === "display" ? pending.find((each) => each.core === core.id && isAsking(each.operation)) : undefined;
    if (asked === undefined) continue;
    return waitOf(key, asked, callIn(questions, key, asked.core_call));
  }
  return undefined;
}
