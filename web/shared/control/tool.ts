// The tool at the arm while somebody moves it by hand: that it is another one than before, or that its service is gone.
import type { HostedService } from "../../generated/messages";
import { movableOf } from "./jog";

type Described = Pick<HostedService, "key" | "available" | "rsm">;

export interface Tool {
  /** As in svc.<key>. */
  readonly key: string;
  readonly name: string;
}

/** The one that is there; nothing: none is. */
export function toolOf(services: readonly Described[]): Tool | undefined {
  const key = movableOf(services).gripper?.key;
  const name = services.find((service) => service.key === key)?.rsm.name;
  return key === undefined || name === undefined ? undefined : { key, name };
}

/** What is to be said; nothing: it is the tool `before`, or there was none. */
export function toolWarning(before: Tool | undefined, services: readonly Described[]): string | undefined {
  const now = toolOf(services);
  if (before === undefined) return undefined;
  if (now === undefined) return `The gripper is not connected any more (${before.key}): it does not open or close from here. See whether it is switched on.`;
  if (now.key === before.key && now.name === before.name) return undefined;
  return `Another gripper is at the arm: ${now.name} instead of ${before.name}. Poses that were taught with the other one may not fit: go there slowly.`;
}
