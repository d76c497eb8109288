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

export type ToolChange = { readonly kind: "gone"; readonly before: Tool } | { readonly kind: "another"; readonly before: Tool; readonly now: Tool };

/** What has become of the tool `before`; nothing: it is there, or there was none. */
export function toolChange(before: Tool | undefined, services: readonly Described[]): ToolChange | undefined {
  const now = toolOf(services);
  if (before === undefined) return undefined;
  if (now === undefined) return { kind: "gone", before };
  return now.key === before.key && now.name === before.name ? undefined : { kind: "another", before, now };
}
