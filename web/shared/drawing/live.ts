// What a run lights up in a drawing: pure look-ups, made once per change of the run.
import type { Fault, RunState } from "../../generated/messages";
import type { JsonValue } from "../json";
import type { DrawnLine } from "./drawing";
import type { Line } from "../model/describe";

export interface Live {
  readonly active: ReadonlySet<string>;
  readonly ports: ReadonlySet<string>;
  readonly fired: ReadonlySet<string>;
  /** Grows with every step in which a port fired. */
  readonly beat: number;
  readonly activated: Readonly<Record<string, readonly string[]>>;
  readonly run: RunState | undefined;
  readonly faultAt: string | undefined;
}

export const still: Live = {
  active: new Set(), ports: new Set(), fired: new Set(), beat: 0, activated: {}, run: undefined, faultAt: undefined,
};

export function liveOf(run: RunState | undefined, fired: { readonly beat: number; readonly ports: readonly string[] }, fault: Fault | undefined): Live {
  if (run === undefined) return still;
  return {
    active: new Set(run.active),
    ports: new Set(run.ports),
    fired: new Set(fired.ports),
    beat: fired.beat,
    activated: run.activated,
    run,
    faultAt: fault?.at,
  };
}

/** The live value that belongs to a line of a state's text section; the same object while it does not change. */
export function liveValue(live: Live, path: string, line: Line): JsonValue | undefined {
  if (line.name === undefined || live.run === undefined) return undefined;
  switch (line.label) {
    case "params":
      return live.run.parameters[path]?.[line.name];
    case "results":
      return live.run.results[path]?.[line.name];
    case "vars":
      return live.run.variables[path]?.[line.name];
    default:
      return undefined;
  }
}

/** How a line looks now: `fired` where its port just fired, `active` where its port waits to be taken. */
export function lineState(line: DrawnLine, live: Live): "fired" | "active" | "idle" {
  if (live.fired.has(line.from)) return "fired";
  return live.ports.has(line.from) ? "active" : "idle";
}
