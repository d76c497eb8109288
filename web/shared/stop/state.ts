// What a page knows of the stop and of the controls, as a value.
import type { CellMode, Control } from "../../generated/messages";

/** Who stopped the cell, and when [ms since 1970], as far as it is known. */
export interface Stopped {
  readonly by?: string;
  readonly time?: number;
}

export interface StopState {
  /** null: the cell is free; nothing: not known. */
  readonly stopped: Stopped | null | undefined;
  readonly leases: Control["leases"];
  /** Nothing: not known. */
  readonly mode: CellMode | undefined;
  readonly holder: Control["holder"];
  /** Who asks for the controls. */
  readonly request: Control["request"];
  /** The taking of the controls by this page, if it has them. */
  readonly held: number | undefined;
  readonly ports: Control["stop_ports"];
  /** The stop of this page: under way, under way without an answer to its first attempt, or given up. */
  readonly sent: "no" | "sending" | "late" | "failed";
}

export type StopEvent =
  | { readonly type: "told"; readonly control: Control }
  /** The server does not answer. */
  | { readonly type: "lost" }
  | { readonly type: "pressed" }
  | { readonly type: "late" }
  /** `time`: by the clock of the page [ms since 1970]. */
  | { readonly type: "answered"; readonly time: number }
  | { readonly type: "failed" }
  /** This page has the controls from now on, or no more. */
  | { readonly type: "held"; readonly number: number | undefined }
  /** A reset takes back what is left of it. */
  | { readonly type: "withdrawn" }
  /** A person has read that it failed. */
  | { readonly type: "read" };

export const kFirstStop: StopState = { stopped: undefined, leases: [], mode: undefined, holder: null, request: null, held: undefined, ports: [], sent: "no" };

export function applyStop(state: StopState, event: StopEvent): StopState {
  switch (event.type) {
    case "told": {
      const { stopped, leases, mode, holder, request, stop_ports: ports } = event.control;
      const next = stopped === null ? null : { by: stopped.by, ...(stopped.time > 0 && { time: stopped.time }) };
      // That a stop failed is said until the cell stands, or somebody has read it.
      return { ...state, stopped: next, leases, mode, holder, request, ports, sent: next !== null && state.sent === "failed" ? "no" : state.sent };
    }
    case "lost":
      return { ...state, ...(state.stopped === null && { stopped: undefined, leases: [] }), mode: undefined, holder: null, request: null };
    case "pressed":
      return { ...state, sent: "sending" };
    case "late":
      return state.sent === "sending" ? { ...state, sent: "late" } : state;
    case "answered":
      return { ...state, stopped: state.stopped ?? { time: event.time }, leases: [], sent: "no" };
    case "failed":
      return state.sent === "no" ? state : { ...state, sent: "failed" };
    case "held":
      return { ...state, held: event.number };
    case "withdrawn":
      return { ...state, sent: "no" };
    case "read":
      return state.sent === "failed" ? { ...state, sent: "no" } : state;
  }
}

export const isStopped = ({ stopped }: Pick<StopState, "stopped">): boolean => stopped !== null && stopped !== undefined;

/** The one thing that a page says of it. */
export type StopView = "unknown" | "free" | "stopped" | "sending" | "late" | "failed";

export function viewOf({ stopped, sent }: StopState): StopView {
  if (sent !== "no") return sent;
  return stopped === undefined ? "unknown" : stopped === null ? "free" : "stopped";
}
