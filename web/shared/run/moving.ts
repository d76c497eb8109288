// What a run may set in motion: the services of which it calls an operation that moves (api/schemas/service.json).
import type { HostedService } from "../../generated/messages";
import type { RcmDocument } from "../model/model";
import { callsOf } from "../orchestration/calls";

type Described = Pick<HostedService, "key" | "type" | "rsm">;

/** Whether an operation of a service may set something in motion. */
export const moves = ({ rsm }: Pick<Described, "rsm">, operation: string): boolean => rsm.operations.some(({ name, moves }) => name === operation && moves === true);

/** The keys of the services that the model may let move something, sorted. A computed service may be any. Nothing: model or services are not known yet,
 *  so it may move anything. */
export function movedBy(model: Pick<RcmDocument, "root" | "services"> | undefined, services: readonly Described[]): readonly string[] | undefined {
  if (model === undefined || services.length === 0) return undefined;
  const byKey = new Map(services.map((service) => [service.key, service]));
  const meant = (key: string): Described | undefined => byKey.get(key) ?? services.find(({ type }) => type === model.services[key]);
  const found = callsOf(model.root).flatMap(({ service, operation }): readonly string[] => {
    const candidates = service === undefined ? services : [meant(service)].filter((each) => each !== undefined);
    return candidates.filter((each) => moves(each, operation)).map(({ key }) => key);
  });
  return [...new Set(found)].sort();
}

/** "This moves `gripper` and `robot`." */
export const movesText = (keys: readonly string[] | undefined): string => (keys === undefined ? "This may move a robot: the task is not here yet." : `This moves ${keys.map((key) => `\`${key}\``).join(" and ")}.`);
