// The services that the server has, as far as code names them: the same list until one comes, goes, or is another.
import type { KnownService } from "../../../shared/code/services";
import { session, useSession } from "../../client";

let last: readonly KnownService[] = [];

const isSame = (one: KnownService, other: KnownService | undefined): boolean => one.key === other?.key && one.rsm === other.rsm;

/** What a service does now changes with every transition; what it offers does not. */
function known(services: readonly KnownService[]): readonly KnownService[] {
  if (services.length !== last.length || !services.every((service, i) => isSame(service, last[i]))) last = services;
  return last;
}

export const knownServicesNow = (): readonly KnownService[] => known(session.get().services);

export const useKnownServices = (): readonly KnownService[] => useSession(({ services }) => known(services));
