// A run over its macro steps: when its states were active, what it called and how long that took, and the numbers that it had.
import type { Input, RunState, TraceStep } from "../../generated/messages";
import { callText } from "../run/inputText";
import { secondsAt, type Times } from "./times";

/** What a time line keeps of a macro step: its derivation is not. */
export interface LineStep {
  readonly step: number;
  readonly input: Input;
  /** What was called in it, as texts by the numbers of the calls. */
  readonly calls: readonly (readonly [call: number, text: string])[];
  /** Services that were called in it. */
  readonly called: readonly string[];
  /** Paths that are active after it, in tree order. */
  readonly active: readonly string[];
  /** Numbers that names have after it, as `Root/A.res.width`. */
  readonly numbers: ReadonlyMap<string, number>;
}

/** Something that lasts from a macro step on; `to`: the macro step in which it ends. Nothing: it does not. */
export interface Span {
  readonly from: number;
  readonly to: number | undefined;
}

export interface CallSpan extends Span {
  readonly call: number;
  readonly text: string;
  readonly failed: boolean;
}

export interface Timeline {
  /** Macro steps that it has. */
  readonly first: number;
  readonly last: number;
  readonly states: readonly { readonly path: string; readonly spans: readonly Span[] }[];
  readonly calls: readonly CallSpan[];
  /** Names that have had numbers of which two differ, in the order in which they appeared. */
  readonly numbers: readonly string[];
}

const kScopes = [["parameters", "par"], ["results", "res"], ["variables", "var"]] as const;

function numbersOf(state: RunState | undefined): ReadonlyMap<string, number> {
  const found = new Map<string, number>();
  if (state === undefined) return found;
  for (const [scope, short] of kScopes)
    for (const [path, values] of Object.entries(state[scope]))
      for (const [name, value] of Object.entries(values)) if (typeof value === "number") found.set(`${path}.${short}.${name}`, value);
  return found;
}

export const lineStep = ({ step, input, calls, state }: TraceStep): LineStep => ({
  step, input, active: state?.active ?? [], numbers: numbersOf(state),
  called: calls.map(({ service }) => service),
  calls: calls.flatMap((call) => (call.call === undefined ? [] : [[call.call, callText(call)] as const])),
});

function statesOf(steps: readonly LineStep[]): Timeline["states"] {
  const spans = new Map<string, Span[]>();
  for (const [i, { step, active }] of steps.entries()) {
    const before = new Set(steps[i - 1]?.active);
    const now = new Set(active);
    for (const path of active) if (!before.has(path)) spans.set(path, [...(spans.get(path) ?? []), { from: step, to: undefined }]);
    for (const path of before) if (!now.has(path)) spans.set(path, (spans.get(path) ?? []).map((span) => (span.to === undefined ? { ...span, to: step } : span)));
  }
  return [...spans].map(([path, all]) => ({ path, spans: all }));
}

function callsOf(steps: readonly LineStep[]): readonly CallSpan[] {
  const answers = new Map(steps.flatMap(({ step, input }) => (input.kind === "response" ? [[input.call, { step, failed: input.error !== undefined }] as const] : [])));
  return steps.flatMap(({ step, calls }) => calls.map(([call, text]) => ({ call, text, from: step, to: answers.get(call)?.step, failed: answers.get(call)?.failed === true })));
}

function changingNumbers(steps: readonly LineStep[]): readonly string[] {
  const first = new Map<string, number>();
  const changing = new Set<string>();
  for (const { numbers } of steps)
    for (const [name, value] of numbers) {
      const known = first.get(name);
      if (known === undefined) first.set(name, value);
      else if (known !== value) changing.add(name);
    }
  return [...first.keys()].filter((name) => changing.has(name));
}

/** Of macro steps that follow each other, at least one. */
export function timelineOf(steps: readonly LineStep[]): Timeline {
  return { first: steps[0]?.step ?? 1, last: steps.at(-1)?.step ?? 1, states: statesOf(steps), calls: callsOf(steps), numbers: changingNumbers(steps) };
}

/** The number in each macro step; null where it has none. */
export const seriesOf = (steps: readonly LineStep[], name: string): readonly (number | null)[] => steps.map(({ numbers }) => numbers.get(name) ?? null);

const quoted = (text: string): string => (/[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

/** All numbers that the run had, as comma-separated values (RFC 4180): a row for each macro step, with the seconds at which it began. */
export function csvOf(steps: readonly LineStep[], times: Times | undefined): string {
  const names = [...new Set(steps.flatMap(({ numbers }) => [...numbers.keys()]))];
  const seconds = (step: number) => (times && secondsAt(times, step))?.toString() ?? "";
  const rows = steps.map(({ step, input, numbers }) => [String(step), input.kind, seconds(step), ...names.map((name) => numbers.get(name)?.toString() ?? "")]);
  return [["step", "input", "seconds", ...names], ...rows].map((row) => `${row.map(quoted).join(",")}\r\n`).join("");
}
