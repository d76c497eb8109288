// What a run has called and not been answered, as its services tell.
import type { Core, HostedService } from "../../generated/messages";

export interface OpenCall {
  readonly service: string;
  readonly operation: string;
  /** On the server. */
  readonly call: number;
  /** When it came to its service [s, time of the cell]. */
  readonly time: number;
}

/** Oldest first. */
export const openCallsOf = (core: Core, services: readonly HostedService[]): readonly OpenCall[] =>
  services
    .flatMap(({ key, pending }) => pending.filter((each) => each.core === core.id).map(({ operation, call, time }) => ({ service: key, operation, call, time })))
    .sort((a, b) => a.time - b.time);

/** `now`: nothing if the time of the cell is not known. */
export const calledText = ({ time }: OpenCall, now: number | undefined): string => (now === undefined || now < time ? "called, not answered yet" : `called ${(now - time).toFixed(1)} s ago`);
