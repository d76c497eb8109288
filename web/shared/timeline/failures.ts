// The steps of a run that have failed since the page watches it, and what became of each: read from the ports that fire.
import type { Fired } from "../run/fired";
import { splitAddress, type ModelTree } from "../model/modelTree";
import { failedIn, type Failed } from "./progress";
import type { Step, Then } from "./timeLine";

/** The step was tried again; left out, as a person said; the task went on, its loop ended, or it was stopped; or it leads where only the model says. */
export type Became = "again" | "skipped" | "next" | "left" | "stopped" | "elsewhere";

export interface StepFailure extends Failed {
  /** What the step itself has found out. */
  readonly why: string | undefined;
  /** Nothing: that is not decided yet. */
  readonly became: Became | undefined;
}

export interface FailureLog {
  readonly run: string | undefined;
  /** Which ports were read: of this count, these. */
  readonly fireCount: number;
  readonly read: ReadonlySet<string>;
  /** The last kMostFailures, oldest first. */
  readonly failures: readonly StepFailure[];
}

export const kNoFailures: FailureLog = { run: undefined, fireCount: 0, read: new Set(), failures: [] };
export const kMostFailures = 100;

const becameBy: Readonly<Record<Then, Became | undefined>> = { stop: "stopped", next: "next", leave: "left", ask: undefined };

/** What becomes of a failure by the error itself. */
function atOnce({ failure }: Step): Became | undefined {
  if (failure === undefined) return "elsewhere";
  return failure.kind === "retry" ? undefined : becameBy[failure.kind];
}

/** What becomes of it by a port of what handles it (`Retry`, `WhatNow`: api/skills.md). */
function byHandler(port: string, { failure }: Step): Became | undefined {
  if (port === "again" || port === "retry") return "again";
  if (port === "skip") return "skipped";
  if (port === "abort") return "stopped";
  return port === "give_up" && failure?.kind === "retry" ? becameBy[failure.then] : undefined;
}

export interface Watched {
  readonly run: string;
  readonly model: ModelTree;
  readonly steps: readonly Step[];
  /** What a step has found out, by its id. */
  readonly whyOf: (id: string) => string | undefined;
}

/** The log with the ports that have fired since; the same one, if none has. Another run has another log. */
export function withFailures(log: FailureLog, { fireCount, ports }: Pick<Fired, "fireCount" | "ports">, { run, model, steps, whyOf }: Watched): FailureLog {
  const before = log.run === run ? log : { ...kNoFailures, run };
  const fresh = before.fireCount === fireCount ? ports.filter((port) => !before.read.has(port)) : ports;
  if (fresh.length === 0 && before === log) return log;
  let { failures } = before;
  for (const address of fresh) {
    const failed = failedIn([address], model, steps);
    if (failed !== undefined) failures = [...failures, { ...failed, why: whyOf(failed.step.id), became: atOnce(failed.step) }];
    else failures = handledBy(address, failures, model);
  }
  return { run, fireCount, read: new Set(ports), failures: failures.slice(-kMostFailures) };
}

function handledBy(address: string, failures: readonly StepFailure[], model: ModelTree): readonly StepFailure[] {
  const parts = splitAddress(address);
  const id = parts === undefined ? undefined : model.get(parts.path)?.node.id;
  const failure = failures.filter(({ step, became }) => became === undefined && id !== undefined && step.handlers.includes(id)).at(-1);
  if (failure === undefined || parts === undefined) return failures;
  const became = byHandler(parts.port, failure.step);
  return failures.map((each) => (each === failure ? { ...each, became } : each));
}

/** A failure that a run is past, as often as it came so in a row. */
export interface PastFailure {
  readonly failure: StepFailure;
  readonly became: Became;
  readonly times: number;
}

/** What a run is past, oldest first; `except`: what is shown otherwise. */
export function pastOf({ failures }: FailureLog, except?: StepFailure): readonly PastFailure[] {
  const past: PastFailure[] = [];
  for (const failure of failures) {
    const { became } = failure;
    if (became === undefined || failure === except) continue;
    const last = past.at(-1);
    if (last !== undefined && last.failure.step.id === failure.step.id && last.failure.title === failure.title && last.became === became) past[past.length - 1] = { ...last, times: last.times + 1 };
    else past.push({ failure, became, times: 1 });
  }
  return past;
}

/** The failure of a step of which it is not decided what becomes; nothing: the log does not have it. */
export function openOf({ failures }: FailureLog, step: string): StepFailure | undefined {
  return failures.filter((each) => each.step.id === step && each.became === undefined).at(-1);
}

/** The failure with which a run has ended badly: nobody has put it right. Nothing: the log does not have it. */
export function lastOf({ failures }: FailureLog): StepFailure | undefined {
  const last = failures.at(-1);
  return last !== undefined && (last.became === undefined || last.became === "stopped") ? last : undefined;
}
