// Forcing the outcome of a state, or a value of it, in a run.
import type { Core, Force } from "../../generated/messages";
import { readExact, type ExactJson } from "../edit/exact";
import { nameOf } from "../model/modelTree";

export type ForceScope = Force["scope"];

/** What is proposed, before it is confirmed. */
export interface Proposal {
  readonly path: string;
  readonly scope: ForceScope;
  readonly name: string;
  /** The value as it is now, as JSON; of a port: nothing. */
  readonly text?: string;
}

const kNames: Readonly<Record<Exclude<ForceScope, "port">, string>> = { par: "parameter", res: "result", var: "variable" };

/** What would be done. */
export function proposalText({ path, scope, name }: Proposal): string {
  return scope === "port" ? `Leave ${nameOf(path)} through ${name}?` : `Set the ${kNames[scope]} ${name} of ${nameOf(path)} to`;
}

/** What was typed as a value, with its numbers as they were written. */
export function typedValue(text: string): { readonly value: ExactJson } | { readonly reason: string } {
  try {
    return { value: readExact(text) };
  } catch {
    return { reason: "This is no value. Write it as JSON: 0.3, true, \"text\", [1, 2]" };
  }
}

/** Why nothing can be forced now. */
export function reasonAgainstForce(core: Core | undefined): string | undefined {
  if (core === undefined) return "no run is watched";
  if (core.status !== "running") return "the run is not running";
  return core.micro > 0 ? "the run is within a macro step; a macro step ends it" : undefined;
}
