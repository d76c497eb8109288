// A run that waits for a person: its call of a display that is not answered yet, with the question in words.
import type { Call, Core, HostedService, TraceStep } from "../../generated/messages";
import type { JsonValue } from "../json";

export interface PersonWait {
  /** As in svc.<key>. */
  readonly service: string;
  readonly operation: string;
  /** Nothing, if the step that asked is not here. */
  readonly question: string | undefined;
  /** The displays that show it: one by its name, or `all`. */
  readonly display: string;
}

/** The operations of a display that a person answers, and the place of `display` among their arguments (services/display/README.md). */
const kAsking: ReadonlyMap<string, number> = new Map([["ask", 2], ["choose", 2], ["ask_number", 5]]);

const textOf = (value: JsonValue | undefined): string | undefined => (typeof value === "string" ? value : undefined);

function waitOf(service: string, operation: string, call: Call | undefined): PersonWait {
  const display = textOf(call?.kwargs["display"]) ?? textOf(call?.args[kAsking.get(operation) ?? 0]) ?? "all";
  return { service, operation, question: textOf(call?.kwargs["question"]) ?? textOf(call?.args[0]), display };
}

/** The oldest question of this core that nobody has answered; nothing if it waits for no person. */
export function waitingForPerson(core: Core | undefined, services: readonly HostedService[], steps: readonly TraceStep[]): PersonWait | undefined {
  if (core?.status !== "running") return undefined;
  for (const { key, type, pending } of services) {
    const asked = type === "display" ? pending.find((each) => each.core === core.id && kAsking.has(each.operation)) : undefined;
    if (asked === undefined) continue;
    const isIt = ({ service, call }: Call) => service === key && call === asked.core_call;
    return waitOf(key, asked.operation, steps.flatMap(({ calls }) => calls).filter(isIt).at(-1));
  }
  return undefined;
}

/** The address of the page that shows it (web/display). */
export const displayAddress = ({ display }: PersonWait): string => (display === "all" ? "/display/" : `/display/?name=${encodeURIComponent(display)}`);
