// The operations that a breakpoint on calls can be about, from the RSMs of the services.
import type { HostedService, KeptBreakpoint } from "../../generated/messages";

export interface OperationChoice {
  readonly service?: string;
  readonly operation?: string;
  readonly text: string;
}

type Called = Pick<KeptBreakpoint, "service" | "operation">;

/** What stands for a choice in a list. */
export const operationKey = ({ service = "", operation = "" }: Called): string => `${service}.${operation}`;

/** Any, then those of each service; `chosen` is among them also while its service is not there. */
export function operationChoices(services: readonly Pick<HostedService, "key" | "rsm">[], chosen: Called): readonly OperationChoice[] {
  const known = services.flatMap(({ key, rsm }) => [
    { service: key, text: `any of ${key}` },
    ...rsm.operations.map(({ name }) => ({ service: key, operation: name, text: `${key}.${name}` })),
  ]);
  const all: readonly OperationChoice[] = [{ text: "any operation" }, ...known];
  if (all.some((each) => operationKey(each) === operationKey(chosen))) return all;
  return [...all, { ...(chosen.service !== undefined && { service: chosen.service }), ...(chosen.operation !== undefined && { operation: chosen.operation }), text: operationKey(chosen) }];
}
