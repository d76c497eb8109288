// A core and its state, as the server tells them (api/schemas: core, state, core_state, core_delta, call, input).
import { array, boolean, json, number, object, oneOf, present, record, string, type Decoder, type JsonValue } from "../json/decode";

export interface Fault {
  readonly kind: string;
  readonly at: string;
  readonly message: string;
}

export interface Core {
  readonly id: string;
  readonly document: string;
  readonly status: "ready" | "running" | "ended" | "faulted" | "aborted";
  /** Held, or waiting for an input that its step needs. */
  readonly paused: boolean;
  /** It goes as far as it was told to; with `paused`, once an input arrives. */
  readonly stepping: boolean;
  /** Macro steps begun so far. */
  readonly step: number;
  /** Micro steps done of an incomplete macro step. */
  readonly micro: number;
  /** Inputs that wait. */
  readonly waiting: number;
  readonly arguments: Readonly<Record<string, JsonValue>>;
  readonly outcome?: string;
  readonly fault?: Fault;
}

/** Path -> name -> value. */
export type Values = Readonly<Record<string, Readonly<Record<string, JsonValue>>>>;

/** Δ: what is active, and the values that are set. */
export interface RunState {
  readonly active: readonly string[];
  readonly ports: readonly string[];
  readonly activated: Readonly<Record<string, readonly string[]>>;
  readonly parameters: Values;
  readonly results: Values;
  readonly variables: Values;
}

export interface Call {
  readonly service: string;
  readonly operation: string;
  readonly args: readonly JsonValue[];
  readonly kwargs: Readonly<Record<string, JsonValue>>;
  readonly call?: number;
}

/** What a macro step began with. */
export interface Input {
  readonly kind: string;
  readonly service?: string;
  readonly event?: string;
  readonly operation?: string;
  readonly call?: number;
  readonly data?: JsonValue;
  readonly result?: JsonValue;
  readonly error?: JsonValue;
}

export interface CoreState {
  readonly core: Core;
  readonly state: RunState;
}

type Names = Readonly<Record<string, readonly string[]>>;

/** What a step changed. */
export interface CoreDelta {
  readonly core: Core;
  readonly active: Readonly<Record<string, boolean>>;
  readonly ports: Readonly<Record<string, boolean>>;
  readonly activated: Names;
  readonly parameters: Values;
  readonly results: Values;
  readonly variables: Values;
  readonly unset: { readonly parameters: Names; readonly results: Names; readonly variables: Names };
  readonly fired: readonly string[];
  readonly calls: readonly Call[];
  readonly input?: Input;
}

const fault: Decoder<Fault> = object((f) => ({
  kind: f.need("kind", string),
  at: f.need("at", string),
  message: f.need("message", string),
}));

export const core: Decoder<Core> = object((f) =>
  present<Core>({
    id: f.need("id", string),
    document: f.need("document", string),
    status: f.need("status", oneOf("ready", "running", "ended", "faulted", "aborted")),
    paused: f.need("paused", boolean),
    stepping: f.need("stepping", boolean),
    step: f.need("step", number),
    micro: f.need("micro", number),
    waiting: f.need("waiting", number),
    arguments: f.need("arguments", record(json)),
    outcome: f.maybe("outcome", string),
    fault: f.maybe("fault", fault),
  }),
);

export const cores: Decoder<readonly Core[]> = object((f) => f.need("cores", array(core)));

const values: Decoder<Values> = record(record(json));
const names: Decoder<Names> = record(array(string));

export const runState: Decoder<RunState> = object((f) => ({
  active: f.need("active", array(string)),
  ports: f.need("ports", array(string)),
  activated: f.need("activated", names),
  parameters: f.need("parameters", values),
  results: f.need("results", values),
  variables: f.need("variables", values),
}));

export const call: Decoder<Call> = object((f) =>
  present<Call>({
    service: f.need("service", string),
    operation: f.need("operation", string),
    args: f.need("args", array(json)),
    kwargs: f.need("kwargs", record(json)),
    call: f.maybe("call", number),
  }),
);

export const input: Decoder<Input> = object((f) =>
  present<Input>({
    kind: f.need("kind", string),
    service: f.maybe("service", string),
    event: f.maybe("event", string),
    operation: f.maybe("operation", string),
    call: f.maybe("call", number),
    data: f.maybe("data", json),
    result: f.maybe("result", json),
    error: f.maybe("error", json),
  }),
);

export const coreState: Decoder<CoreState> = object((f) => ({ core: f.need("core", core), state: f.need("state", runState) }));

const unset = object((f) => ({
  parameters: f.or("parameters", names, {}),
  results: f.or("results", names, {}),
  variables: f.or("variables", names, {}),
}));

export const coreDelta: Decoder<CoreDelta> = object((f) =>
  present<CoreDelta>({
    core: f.need("core", core),
    active: f.need("active", record(boolean)),
    ports: f.need("ports", record(boolean)),
    activated: f.need("activated", names),
    parameters: f.need("parameters", values),
    results: f.need("results", values),
    variables: f.need("variables", values),
    unset: f.need("unset", unset),
    fired: f.need("fired", array(string)),
    calls: f.need("calls", array(call)),
    input: f.maybe("input", input),
  }),
);
