// What a run has told the displays, by its calls and the responses that it hears: the text that they show now, and what nobody sees because no
// display is connected. A run hears no response of which nothing in the task depends.
import type { Call, HostedService, Input } from "../../generated/messages";
import { isAsking, isShowing, textArgument } from "./displayCalls";
import { moves } from "./moving";

export interface OnDisplays {
  /** Calls of displays of which no response was heard: the latest of each service and operation (R17). */
  readonly open: readonly Call[];
  /** The call that shows what is read there now. */
  readonly shown: Call | undefined;
  /** The latest call that no display has taken: nothing, once one takes something or the run moves something. */
  readonly unseen: Call | undefined;
}

export const kNothingTold: OnDisplays = { open: [], shown: undefined, unseen: undefined };

type Services = readonly Pick<HostedService, "key" | "type" | "rsm">[];
type States = readonly Pick<HostedService, "key" | "last" | "pending_count">[];
type Response = Extract<Input, { readonly kind: "response" }>;

/** A display is not there, or is not there any more (services/display). */
const kNoDisplay: ReadonlySet<unknown> = new Set(["no_display", "display_lost"]);

const codeOf = ({ error }: Response): unknown => (typeof error === "object" && error !== null && "code" in error ? error.code : undefined);

function answered(told: OnDisplays, response: Response): OnDisplays {
  const call = told.open.find((each) => each.call === response.call);
  if (call === undefined) return told;
  const open = told.open.filter((each) => each !== call);
  if (response.error === undefined) return { ...told, open, unseen: call.operation === "clear" ? told.unseen : undefined };
  const shown = told.shown === call ? undefined : told.shown;
  return { open, shown, unseen: kNoDisplay.has(codeOf(response)) && call.operation !== "clear" ? call : told.unseen };
}

function called(told: OnDisplays, call: Call, services: Services): OnDisplays {
  const service = services.find(({ key }) => key === call.service);
  if (service === undefined) return told;
  if (service.type === "display") {
    const open = [...told.open.filter((each) => each.service !== call.service || each.operation !== call.operation), call];
    return { ...told, open, shown: isShowing(call.operation) ? call : call.operation === "clear" ? undefined : told.shown };
  }
  return moves(service, call.operation) ? { ...told, open: [], unseen: undefined } : told;
}

/** After a macro step, or a part of one. */
export function tellDisplays(told: OnDisplays, { input, calls }: { readonly input?: Input | undefined; readonly calls: readonly Call[] }, services: Services): OnDisplays {
  const heard = input?.kind === "response" ? answered(told, input) : told;
  return calls.reduce((now, call) => called(now, call, services), heard);
}

/** A question that a display has refused, or that was on one which is gone: transitions (services/display). */
const kRefusals: ReadonlySet<unknown> = new Set(["refused", "lost"]);

/** A question that no display has taken, without the run having heard of it. */
const unheardQuestion = ({ open }: OnDisplays, states: States): Call | undefined =>
  open.filter(({ service, operation }) => isAsking(operation) && states.some(({ key, last, pending_count }) => key === service && pending_count === 0 && kRefusals.has(last))).at(-1);

/** What nobody sees; `isHeard`: the run has heard that no display is there, else one may have refused what it was told. */
export interface Unseen {
  readonly call: Call;
  readonly isHeard: boolean;
}

export function unseenOf(told: OnDisplays, states: States): Unseen | undefined {
  const unheard = told.unseen ?? unheardQuestion(told, states);
  return unheard && { call: unheard, isHeard: unheard === told.unseen };
}

/** What the displays of a call read; nothing: it has no text. */
export function textOn(call: Call): string | undefined {
  const text = call.operation === "show_image" ? (textArgument(call, "text", 1) ?? "a picture") : textArgument(call, isShowing(call.operation) ? "text" : "question", 0);
  return text === "" ? undefined : text;
}
