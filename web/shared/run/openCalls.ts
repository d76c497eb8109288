// What a run has called and not been answered, as its services tell.
import type { Core, HostedService } from "../../generated/messages";
import type { PersonWait } from "./waitingForPerson";

export interface OpenCall {
  readonly service: string;
  readonly operation: string;
  /** On the server. */
  readonly call: number;
  /** In its core; nothing: the server itself has called. */
  readonly coreCall: number | undefined;
  /** When it came to its service [s, time of the cell]. */
  readonly time: number;
}

/** Oldest first. */
export const openCallsOf = (core: Core, services: readonly HostedService[]): readonly OpenCall[] =>
  services
    .flatMap(({ key, pending }) => pending.filter((each) => each.core === core.id).map(({ operation, call, core_call, time }) => ({ service: key, operation, call, coreCall: core_call, time })))
    .sort((a, b) => a.time - b.time);

/** `now`: nothing if the time of the cell is not known. `wait`: the question that a person is asked, of one of the calls. */
export function calledText({ service, coreCall, time }: OpenCall, now: number | undefined, wait?: PersonWait): string {
  const since = now === undefined || now < time ? "called, not answered yet" : `called ${(now - time).toFixed(1)} s ago`;
  const isAsked = wait?.question !== undefined && wait.service === service && wait.call === coreCall;
  return isAsked ? `“${wait.question}”, ${since}` : since;
}
