// What a run may set in motion: the services of which it calls an operation that moves (api/schemas/service.json).
import type { HostedService } from "../../generated/messages";
import type { RcmDocument, State } from "../model/model";
import { callsIn, type Call } from "../orchestration/calls";

type Described = Pick<HostedService, "key" | "type" | "rsm">;

const textsOf = ({ entry, exit, oracle, actions }: State): readonly string[] => [entry, exit, oracle, ...actions.map((action) => action.do)].filter((text) => text !== undefined);

const callsOf = (state: State): readonly Call[] => [
  ...textsOf(state).flatMap(callsIn),
  ...state.children.flatMap((child) => (child.kind === "state" ? callsOf(child) : [])),
];

const moves = ({ rsm }: Described, operation: string): boolean => rsm.operations.some(({ name, moves }) => name === operation && moves === true);

/** The keys of the services that the model may let move something, sorted. A computed service may be any; of a model that is not known yet, all may be. */
export function movedBy(model: Pick<RcmDocument, "root" | "services"> | undefined, services: readonly Described[]): readonly string[] {
  if (model === undefined) return services.filter(({ rsm }) => rsm.operations.some((each) => each.moves === true)).map(({ key }) => key).sort();
  const byKey = new Map(services.map((service) => [service.key, service]));
  const meant = (key: string): Described | undefined => byKey.get(key) ?? services.find(({ type }) => type === model.services[key]);
  const found = callsOf(model.root).flatMap(({ service, operation }): readonly string[] => {
    const candidates = service === undefined ? services : [meant(service)].filter((each) => each !== undefined);
    return candidates.filter((each) => moves(each, operation)).map(({ key }) => key);
  });
  return [...new Set(found)].sort();
}

/** "`robot`", "`gripper` and `robot`". */
export const namesText = (keys: readonly string[]): string => keys.map((key) => `\`${key}\``).join(" and ");
