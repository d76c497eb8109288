// The text section of a drawn state (Fig. 3.2, 3.3): parameters, results, functions and actions in one line each.
import type { JsonValue } from "../json";
import type { Parameter, Port, State } from "./model";

/** One line below a state's name; `label` is the thesis' word for it. */
export interface Line {
  readonly label: "params" | "results" | "vars" | "entry" | "exit" | "action";
  readonly text: string;
  /** The parameter, result or variable that the line is about: its live value may stand beside it. */
  readonly name?: string;
}

/** A value in one line, as a task author would write it. */
export function valueText(value: JsonValue | undefined): string {
  if (value === undefined) return "–";
  if (value === null) return "None";
  if (typeof value === "boolean") return value ? "True" : "False";
  if (typeof value === "string") return `'${value}'`;
  if (typeof value === "number") return numberText(value);
  if (Array.isArray(value)) return `[${value.map(valueText).join(", ")}]`;
  return `{${Object.entries(value)
    .map(([key, entry]) => `${key}: ${valueText(entry)}`)
    .join(", ")}}`;
}

function numberText(value: number): string {
  return Number.isInteger(value) ? String(value) : String(Number(value.toPrecision(6)));
}

export function parameterText(parameter: Parameter): string {
  if (parameter.from !== undefined) return `${parameter.name} ← ${parameter.from}`;
  return parameter.value === undefined ? `${parameter.name} (required)` : `${parameter.name} = ${valueText(parameter.value)}`;
}

const kOneTerm = /^[\w.]+$/;

/** When a port fires: its condition, or its time-out. */
export function portText({ when, after }: Port): string {
  if (after === undefined) return when;
  return `after ${kOneTerm.test(after) ? after : `(${after})`} s`;
}

/** The first line of a function, with a mark where more follows. */
export function codeText(code: string): string {
  const lines = code.split("\n").filter((line) => line.trim() !== "");
  return lines.length > 1 ? `${lines[0] ?? ""} …` : (lines[0] ?? "");
}

/** What the author of the state has written. */
export function describeState(state: State): readonly Line[] {
  const variables = state.variables.filter(({ made }) => made !== true);
  const actions = state.actions.filter(({ made }) => made !== true);
  return [
    ...state.parameters.map((p): Line => ({ label: "params", text: parameterText(p), name: p.name })),
    ...state.results.map((r): Line => ({ label: "results", text: r.name, name: r.name })),
    ...variables.map((v): Line => ({ label: "vars", text: v.name, name: v.name })),
    ...(state.entry === undefined ? [] : [{ label: "entry", text: codeText(state.entry) } as const]),
    ...(state.exit === undefined ? [] : [{ label: "exit", text: codeText(state.exit) } as const]),
    ...actions.map((a): Line => ({ label: "action", text: `[${a.when}] ${codeText(a.do)}` })),
  ];
}

/** Cuts a text that would be wider than `limit` characters. */
export function clip(text: string, limit: number): string {
  return text.length <= limit ? text : `${text.slice(0, limit - 1)}…`;
}
