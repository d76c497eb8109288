// Derivations and rules, as the server tells them (api/schemas: derivation, trace_step, derivations, rules).
import { array, boolean, json, number, object, present, record, string, type Decoder, type JsonValue } from "../json/decode";
import { call, input, type Call, type Input } from "./core";

/** A proof tree (core/SEMANTICS.md, section 7). `value` is there where `hasValue` says so: it may be null. */
export interface Derivation {
  readonly rule: string;
  readonly equation: string;
  readonly at: string;
  readonly premises: readonly Derivation[];
  readonly port?: string;
  readonly action?: number;
  readonly parameter?: string;
  readonly value?: JsonValue;
  readonly requires?: readonly string[];
  readonly refinement?: string;
  readonly service?: string;
  readonly operation?: string;
  readonly args?: readonly JsonValue[];
  readonly kwargs?: Readonly<Record<string, JsonValue>>;
  readonly of?: string;
}

/** The derivation of one macro step, or of a part of it. */
export interface TraceStep {
  readonly step: number;
  readonly input: Input;
  readonly micro: readonly Derivation[];
  readonly calls: readonly Call[];
  /** Number of the first micro step in `micro`. */
  readonly first: number;
  readonly complete: boolean;
}

export interface RuleText {
  readonly rule: string;
  readonly equation: string;
  readonly layer: string;
  readonly text: string;
}

export const derivation: Decoder<Derivation> = object((f) =>
  present<Derivation>({
    rule: f.need("rule", string),
    equation: f.need("equation", string),
    at: f.need("at", string),
    premises: f.need("premises", array((value, path) => derivation(value, path))),
    port: f.maybe("port", string),
    action: f.maybe("action", number),
    parameter: f.maybe("parameter", string),
    value: f.maybe("value", json),
    requires: f.maybe("requires", array(string)),
    refinement: f.maybe("refinement", string),
    service: f.maybe("service", string),
    operation: f.maybe("operation", string),
    args: f.maybe("args", array(json)),
    kwargs: f.maybe("kwargs", record(json)),
    of: f.maybe("of", string),
  }),
);

export const traceStep: Decoder<TraceStep> = object((f) => ({
  step: f.need("step", number),
  input: f.need("input", input),
  micro: f.need("micro", array(derivation)),
  calls: f.need("calls", array(call)),
  first: f.or("first", number, 0),
  complete: f.or("complete", boolean, true),
}));

export const traceSteps: Decoder<readonly TraceStep[]> = object((f) => f.need("steps", array(traceStep)));

export const rules: Decoder<readonly RuleText[]> = object((f) =>
  f.need(
    "rules",
    array(
      object((r) => ({
        rule: r.need("rule", string),
        equation: r.need("equation", string),
        layer: r.need("layer", string),
        text: r.need("text", string),
      })),
    ),
  ),
);
