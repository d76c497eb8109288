// A macro step as messages: what it began with, its derivation, its calls, what is active after it, and lines of the log.
import type { Input, Run, ServiceChange, TraceStep } from "../../generated/messages";
import { isBadOutcome } from "../run/controls";
import { loggedStep, type RunEntry } from "../runs/callLog";
import { outcomeText } from "../runs/texts";
import { lineStep } from "../runs/timeline";
import { stampOf, type McapChannel, type McapMessage } from "./message";

const kInputs: McapChannel = { topic: "/race/inputs", schema: "race.Input" };
const kDerivations: McapChannel = { topic: "/race/derivations", schema: "race.Derivation" };
const kCalls: McapChannel = { topic: "/race/calls", schema: "race.Call" };
const kState: McapChannel = { topic: "/race/state", schema: "race.State" };
const kServices: McapChannel = { topic: "/race/services", schema: "race.ServiceState" };
const kLog: McapChannel = { topic: "/log", schema: "foxglove.Log" };
const kLevel = { info: 2, warning: 3, error: 4 } as const;

/** When a macro step was, [us] since 1970. */
export interface StepMoment {
  readonly began: number;
  /** Whether that is recorded. */
  readonly timed: boolean;
  /** When its event or response had come; nothing: not known, or it has none. */
  readonly arrived: number | undefined;
}

function inputFields(input: Input): object {
  switch (input.kind) {
    case "event":
      return { service: input.service, name: input.event, data: JSON.stringify(input.data) };
    case "response": {
      const failed = input.error !== undefined;
      return { service: input.service, name: input.operation, call: input.call, failed, data: JSON.stringify(failed ? input.error : (input.result ?? null)) };
    }
    case "edit":
      return { data: JSON.stringify(input.edit) };
    case "force":
      return { data: JSON.stringify(input.force) };
    default:
      return {};
  }
}

const logMessage = (time: number, level: number, name: string, message: string): McapMessage => ({
  channel: kLog,
  time,
  value: { timestamp: stampOf(time), level, message, name, file: "", line: 0 },
});

function stateMessage(step: TraceStep, { began, timed }: StepMoment): readonly McapMessage[] {
  const { state } = step;
  if (state === undefined) return [];
  const { active, ports, parameters, results, variables } = state;
  const numbers = [...lineStep(step).numbers].map(([name, value]) => ({ name, value }));
  return [{ channel: kState, time: began, value: { timestamp: stampOf(began), step: step.step, timed, active, ports, numbers, values: JSON.stringify({ parameters, results, variables }) } }];
}

/** In the order in which they happen; all at the time at which the macro step began, as no other one is recorded. */
export function stepMessages(step: TraceStep, moment: StepMoment): readonly McapMessage[] {
  const { began: time, arrived } = moment;
  const head = { timestamp: stampOf(time), step: step.step };
  const { entries } = loggedStep(step);
  const made = entries.filter(({ kind }) => kind === "call");
  const failed = step.input.kind === "response" && step.input.error !== undefined;
  const levelOf = ({ kind }: RunEntry): number => (kind === "response" && failed ? kLevel.warning : kLevel.info);
  return [
    { channel: kInputs, time, ...(arrived !== undefined && { published: Math.min(arrived, time) }), value: { ...head, kind: step.input.kind, ...inputFields(step.input) } },
    { channel: kDerivations, time, value: { ...head, micro: step.micro.map((root) => ({ rule: root.rule, equation: root.equation, at: root.at, tree: JSON.stringify(root) })) } },
    ...step.calls.map(({ call, service, operation, args, kwargs }, i): McapMessage => ({
      channel: kCalls,
      time,
      value: { ...head, micro: made[i]?.micro ?? 0, ...(call !== undefined && { call }), service, operation, args: JSON.stringify(args), kwargs: JSON.stringify(kwargs) },
    })),
    ...stateMessage(step, moment),
    ...entries.map((entry) => logMessage(time, levelOf(entry), entry.service ?? "run", entry.text)),
  ];
}

/** That a run is over, at `time`. */
export function endMessage(run: Run, time: number): McapMessage {
  const isBad = run.status !== "ended" || isBadOutcome(run.outcome);
  const reason = run.fault === undefined ? "" : `: ${run.fault.message}`;
  return logMessage(time, isBad ? kLevel.error : kLevel.info, "run", `${outcomeText(run)}${reason}`);
}

export const serviceMessage = ({ service, state }: Pick<ServiceChange, "service" | "state">, time: number): McapMessage => ({
  channel: kServices,
  time,
  value: { timestamp: stampOf(time), service, available: state !== undefined, ...(state !== undefined && { state }) },
});
