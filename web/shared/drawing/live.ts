// The live state of a run in a drawing: look-up tables, made once per change of the run.
import type { Fault } from "../../generated/messages";
import type { JsonValue } from "../json";
import type { DrawnLine } from "./drawing";
import type { Line } from "../model/describe";
import type { LiveState } from "../run/liveState";

export interface Live {
  readonly active: ReadonlySet<string>;
  readonly ports: ReadonlySet<string>;
  readonly fired: ReadonlySet<string>;
  /** Grows with every step in which a port fired. */
  readonly fireCount: number;
  readonly activated: Readonly<Record<string, readonly string[]>>;
  readonly run: LiveState | undefined;
  readonly faultAt: string | undefined;
  /** Address of the port of the root through which the run ended badly. */
  readonly badEnd: string | undefined;
}

export const kNoRun: Live = {
  active: new Set(), ports: new Set(), fired: new Set(), fireCount: 0, activated: {}, run: undefined, faultAt: undefined, badEnd: undefined,
};

/** How the run has ended, if it has. */
export interface Ended {
  readonly fault: Fault | undefined;
  /** As Live.badEnd. */
  readonly badEnd: string | undefined;
}

export function liveOf(run: LiveState | undefined, fired: { readonly fireCount: number; readonly ports: readonly string[] }, { fault, badEnd }: Ended): Live {
  if (run === undefined) return kNoRun;
  return {
    active: new Set(run.active),
    ports: new Set(run.ports),
    fired: new Set(fired.ports),
    fireCount: fired.fireCount,
    activated: run.activated,
    run,
    faultAt: fault?.at,
    badEnd,
  };
}

/** The live value that belongs to a line of a state's text section; the same object while it does not change. */
export function liveValue(live: Live, path: string, line: Line): JsonValue | undefined {
  if (line.name === undefined || live.run === undefined) return undefined;
  switch (line.label) {
    case "params":
      return live.run.parameters.get(path)?.[line.name];
    case "results":
      return live.run.results.get(path)?.[line.name];
    case "vars":
      return live.run.variables.get(path)?.[line.name];
    default:
      return undefined;
  }
}

/** How a line looks now: `fired` where its port just fired, `active` where its port is active. */
export function lineState(line: DrawnLine, live: Live): "fired" | "active" | "idle" {
  if (live.fired.has(line.from)) return "fired";
  return live.ports.has(line.from) ? "active" : "idle";
}
