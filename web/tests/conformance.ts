// The conformance cases as fixtures: models and recorded runs that the semantics itself produced.
import { readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Call, Derivation, Document, RcmBarrier, RcmPort, RcmState, RunState } from "../generated/messages";
import { check } from "../shared/messages/check";
import type { RcmDocument } from "../shared/model/model";
import { readModel } from "../shared/model/readModel";
import { readJson } from "./files";
import { compile } from "./schemas";

const folder = new URL("../../tests/conformance/", import.meta.url);

interface RecordedStep {
  /** Absent where the case counts its micro steps only. */
  readonly micro?: readonly Derivation[];
  readonly calls: readonly Call[];
  readonly state: RunState;
}

interface RecordedRun {
  readonly status: "running" | "ended" | "faulted";
  readonly steps: readonly RecordedStep[];
}

const step = {
  type: "object",
  required: ["calls", "state"],
  properties: {
    micro: { type: "array", items: { $ref: "derivation.json" } },
    calls: { type: "array", items: { $ref: "call.json" } },
    state: { $ref: "state.json" },
  },
};
const run = compile<RecordedRun>({
  type: "object",
  required: ["steps", "status"],
  properties: { steps: { type: "array", items: step }, status: { enum: ["running", "ended", "faulted"] } },
});
const document = compile<Document>({ $ref: "document.json" });

const documentOf = (name: string): Document => check(document, readJson(new URL(`${name}/model.json`, folder)));

const ports = (node: RcmState | RcmBarrier): readonly RcmPort[] =>
  "barrier" in node ? [] : [...(node.ports ?? []), ...(node.children ?? []).flatMap(ports)];

/**
 * Cases that run, as pages can draw them: the `errors-*` cases hold documents that are refused, and a port without condition and
 * time-out is that of a link, which a native model does not have.
 */
export const caseNames = readdirSync(fileURLToPath(folder))
  .filter((name) => !name.includes(".") && !name.startsWith("errors-"))
  .filter((name) => ports(documentOf(name).root).every((port) => port.when !== undefined || port.after !== undefined));

export const modelOf = (name: string): RcmDocument => readModel(documentOf(name));

export function runOf(name: string) {
  const { status, steps } = check(run, readJson(new URL(`${name}/expected.json`, folder)));
  return { status, steps: steps.map(({ micro = [], calls, state }) => ({ micro, calls, state })) };
}
