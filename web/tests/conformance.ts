// The conformance cases as fixtures: models and recorded runs that the semantics itself produced.
import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { array, object, oneOf, type Decoder } from "../shared/json/decode";
import { runState, call, type Call, type RunState } from "../shared/messages/core";
import { derivation, type Derivation } from "../shared/messages/derivation";
import { rcmDocument } from "../shared/model/decodeModel";
import type { RcmDocument } from "../shared/model/model";

const folder = new URL("../../tests/conformance/", import.meta.url);

export function readJson(url: URL): unknown {
  return JSON.parse(readFileSync(fileURLToPath(url), "utf8"));
}

export interface RecordedStep {
  readonly micro: readonly Derivation[];
  readonly calls: readonly Call[];
  readonly state: RunState;
}

const step: Decoder<RecordedStep> = object((f) => ({
  micro: f.or("micro", array(derivation), []),
  calls: f.need("calls", array(call)),
  state: f.need("state", runState),
}));

const run = object((f) => ({ steps: f.need("steps", array(step)), status: f.need("status", oneOf("running", "ended", "faulted")) }));

/** Cases that run; the `errors-*` cases hold documents that are refused. */
export const caseNames = readdirSync(fileURLToPath(folder)).filter((name) => !name.includes(".") && !name.startsWith("errors-"));

export const modelOf = (name: string): RcmDocument => rcmDocument(readJson(new URL(`${name}/model.json`, folder)), "");
export const runOf = (name: string) => run(readJson(new URL(`${name}/expected.json`, folder)), "");
