// Services that runs have reserved, and calls that were refused for that.
import type { Control, TraceStep } from "../../generated/messages";

/** A run, and the services that no other run sets in motion meanwhile. */
export interface Reserved {
  readonly core: string;
  readonly services: readonly string[];
}

export function reservedBy(leases: Control["leases"]): readonly Reserved[] {
  const cores = [...new Set(leases.map(({ core }) => core))];
  return cores.map((core) => ({ core, services: leases.filter((lease) => lease.core === core).map(({ service }) => service) }));
}

/** `robot is reserved by`; the run is a link behind it. */
export const reservedText = ({ services }: Reserved): string => `${services.join(", ")} ${services.length > 1 ? "are" : "is"} reserved by`;

/** What somebody has reserved by hand: the taking of the controls, as a lease names it; nothing: a run has it. */
export const byHand = ({ core }: Pick<Reserved, "core">): boolean => core.startsWith("control/");

const fieldOf = (value: unknown, name: string): unknown => (typeof value === "object" && value !== null ? (value as Readonly<Record<string, unknown>>)[name] : undefined);

/** What the last call of a run was refused with because another run had the service; nothing: none was, as far as `steps` tell. */
export function leasedText(steps: readonly Pick<TraceStep, "input">[]): string | undefined {
  for (const { input } of [...steps].reverse()) {
    if (input.kind !== "response" || fieldOf(input.error, "code") !== "leased") continue;
    const message = fieldOf(input.error, "message");
    return `${input.service}.${input.operation} was refused${typeof message === "string" ? `: ${message}` : ""}. Only one run at a time moves a service: wait until the other run is over, or end it.`;
  }
  return undefined;
}
