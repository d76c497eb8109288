// Services as the server tells them (api/schemas: service, services, service_state).
import { array, boolean, number, object, present, string, type Decoder } from "../json/decode";

export interface RsmTransition {
  readonly id: string;
  readonly dst: string;
  /** None: from every state. */
  readonly src?: string;
  /** None: spontaneous. */
  readonly operation?: string;
  readonly events: readonly string[];
  /** Transitions that answer this transition's call. */
  readonly defer: readonly string[];
  /** Code with which the deferred calls that it resolves are answered. */
  readonly error?: string;
}

/** Def. 4.1-4.3; a mere interface has no states. */
export interface Rsm {
  readonly name: string;
  readonly operations: readonly { readonly name: string; readonly safe: boolean; readonly doc?: string }[];
  readonly events: readonly { readonly name: string; readonly sampled: boolean }[];
  readonly states: readonly { readonly name: string; readonly events: readonly string[] }[];
  readonly init?: string;
  readonly transitions: readonly RsmTransition[];
  /** Data flows that it offers, each with what its packets are, in words; a service need not say. */
  readonly flows: Readonly<Record<string, string>>;
}

export interface PendingCall {
  readonly call: number;
  readonly operation: string;
  /** [s] */
  readonly time: number;
  readonly core?: string;
  readonly core_call?: number;
}

export interface Violation {
  readonly time: number;
  readonly rule: string;
  readonly message: string;
  readonly call?: number;
  readonly operation?: string;
}

/** A data flow that a service offers (thesis 4.1), and what passes on it. */
export interface Published {
  readonly flow: string;
  /** From outside: pages such as this one. */
  readonly watchers: number;
  /** [1/s] of world time; 0: no packets pass. */
  readonly rate_hz: number;
}

/** A data flow of another service that a service reads. */
export interface Subscribed {
  readonly service: string;
  readonly flow: string;
  readonly listening: boolean;
}

/** What changes of a service. */
export interface ServiceState {
  readonly key: string;
  readonly state: string | null;
  readonly available: boolean;
  readonly pending: readonly PendingCall[];
  readonly violations: readonly Violation[];
  /** Id of the transition it took last. */
  readonly last?: string;
  readonly publishes: readonly Published[];
  readonly subscribes: readonly Subscribed[];
}

export interface Service extends ServiceState {
  readonly type: string;
  readonly rsm: Rsm;
}

const transition: Decoder<RsmTransition> = object((f) =>
  present<RsmTransition>({
    id: f.need("id", string),
    dst: f.need("dst", string),
    src: f.maybe("src", string),
    operation: f.maybe("operation", string),
    events: f.or("events", array(string), []),
    defer: f.or("defer", array(string), []),
    error: f.maybe("error", string),
  }),
);

/** `meta` may be anything; only flows described in words count. */
const flowsOfMeta: Decoder<Rsm["flows"]> = (value) => {
  if (typeof value !== "object" || value === null || !("flows" in value)) return {};
  const { flows } = value;
  if (typeof flows !== "object" || flows === null) return {};
  return Object.fromEntries(Object.entries(flows).filter((entry): entry is [string, string] => typeof entry[1] === "string"));
};

export const rsm: Decoder<Rsm> = object((f) =>
  present<Rsm>({
    name: f.need("name", string),
    operations: f.need(
      "operations",
      array(
        object((o) =>
          present<Rsm["operations"][number]>({
            name: o.need("name", string),
            safe: o.or("safe", boolean, false),
            doc: o.maybe("doc", string),
          }),
        ),
      ),
    ),
    events: f.need("events", array(object((e) => ({ name: e.need("name", string), sampled: e.or("sampled", boolean, false) })))),
    states: f.or("states", array(object((s) => ({ name: s.need("name", string), events: s.or("events", array(string), []) }))), []),
    init: f.maybe("init", string),
    transitions: f.or("transitions", array(transition), []),
    flows: f.or("meta", flowsOfMeta, {}),
  }),
);

const pendingCall: Decoder<PendingCall> = object((f) =>
  present<PendingCall>({
    call: f.need("call", number),
    operation: f.need("operation", string),
    time: f.need("time", number),
    core: f.maybe("core", string),
    core_call: f.maybe("core_call", number),
  }),
);

const violation: Decoder<Violation> = object((f) =>
  present<Violation>({
    time: f.need("time", number),
    rule: f.need("rule", string),
    message: f.need("message", string),
    call: f.maybe("call", number),
    operation: f.maybe("operation", string),
  }),
);

const published: Decoder<Published> = object((f) => ({
  flow: f.need("flow", string),
  watchers: f.need("watchers", number),
  rate_hz: f.need("rate_hz", number),
}));

const subscribed: Decoder<Subscribed> = object((f) => ({
  service: f.need("service", string),
  flow: f.need("flow", string),
  listening: f.need("listening", boolean),
}));

const nullableString: Decoder<string | null> = (value, path) => (value === null ? null : string(value, path));

export const serviceState: Decoder<ServiceState> = object((f) =>
  present<ServiceState>({
    key: f.need("key", string),
    state: f.need("state", nullableString),
    available: f.need("available", boolean),
    pending: f.need("pending", array(pendingCall)),
    violations: f.need("violations", array(violation)),
    last: f.maybe("last", string),
    publishes: f.need("publishes", array(published)),
    subscribes: f.need("subscribes", array(subscribed)),
  }),
);

const service: Decoder<Service> = (value, path) =>
  object((f) => ({ ...serviceState(value, path), type: f.need("type", string), rsm: f.need("rsm", rsm) }))(value, path);

export const services: Decoder<readonly Service[]> = object((f) => f.need("services", array(service)));
export const serviceStates: Decoder<readonly ServiceState[]> = object((f) => f.need("services", array(serviceState)));
