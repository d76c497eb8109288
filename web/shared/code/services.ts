// The services that code may name, from their RSMs: operations with their parameters and what they answer, and events.
import type { HostedService, RsmOperation } from "../../generated/messages";
import { entryOf, isObject } from "../json";
import type { Tree } from "../edit/tree";
import { valueName, type Name } from "./names";

export type KnownService = Pick<HostedService, "key" | "type" | "rsm">;

type RsmParameter = NonNullable<RsmOperation["parameters"]>[number];

const rangeText = ({ min, max }: RsmParameter): string | undefined => (min === undefined && max === undefined ? undefined : `from ${min ?? "…"} to ${max ?? "…"}`);

const argumentName = (parameter: RsmParameter): Name => {
  const note = rangeText(parameter);
  return { ...valueName(parameter.name, "argument", parameter), ...(note !== undefined && { note }) };
};

function operationName({ name, parameters = [], result, error, doc, safe }: RsmOperation): Name {
  const call = parameters.map((parameter) => (parameter.value === undefined ? parameter.name : `[${parameter.name}]`)).join(", ");
  const answers = (): readonly Name[] => [
    valueName("result", "answer", { type: result, doc: "What the operation has answered; known when it has." }),
    valueName("error", "answer", { type: error ?? { record: { code: "string" } }, doc: "Why the call has failed; known when it has." }),
  ];
  return { name, kind: "operation", call, parameters: parameters.map(argumentName), ...(safe === true && { note: "Safe: it is called when a run faults." }), ...(doc !== undefined && { doc }), ...(result !== undefined && { type: result }), members: answers };
}

function eventName({ name, data, doc, rate_hz: rate }: KnownService["rsm"]["events"][number]): Name {
  const value = valueName(name, "event", { type: data, doc });
  const latest = valueName("latest", "answer", { type: data, doc: "The last data that was ever received." });
  return { ...value, ...(rate !== undefined && { note: `${rate} times a second.` }), members: () => [latest, ...(value.members?.() ?? [])] };
}

function serviceName(key: string, { type, rsm }: KnownService): Name {
  return { name: key, kind: "service", doc: `A service of the type ${type}.`, members: () => [...rsm.operations.map(operationName), ...rsm.events.map(eventName)] };
}

/** A service by its key in code; one that is not there now has a type alone. */
type NamedService = KnownService | { readonly key: string; readonly type: string; readonly rsm?: undefined };

/** What a document declares: types by keys. */
type Declared = Readonly<Record<string, unknown>>;

const declaredIn = (tree: Tree): Declared => {
  const services = entryOf(tree.fields, "services");
  return isObject(services) ? services : {};
};

/** Those that the document declares, by key, else by type, and the others that the server has. */
function servicesFor(declared: Declared, known: readonly KnownService[]): readonly NamedService[] {
  const found = new Map<string, NamedService>(known.map((service) => [service.key, service]));
  for (const [key, type] of Object.entries(declared)) {
    const service = known.find((each) => each.key === key) ?? known.find((each) => each.type === type);
    found.set(key, service === undefined ? { key, type: typeof type === "string" ? type : "?" } : { ...service, key });
  }
  return [...found.values()];
}

/** Of a service that is not there now, nothing more is known. */
export const namesOfServices = (declared: Declared, known: readonly KnownService[]): readonly Name[] =>
  servicesFor(declared, known).map((service) =>
    service.rsm === undefined ? { name: service.key, kind: "service", doc: `A service of the type ${service.type}, which is not there now.`, isOpen: true } : serviceName(service.key, service),
  );

export const serviceNames = (tree: Tree, known: readonly KnownService[]): readonly Name[] => namesOfServices(declaredIn(tree), known);

/** The services that code can name and that are there, with their RSMs. */
export const knownServices = (tree: Tree, known: readonly KnownService[]): readonly KnownService[] =>
  servicesFor(declaredIn(tree), known).filter((service): service is KnownService => service.rsm !== undefined);
