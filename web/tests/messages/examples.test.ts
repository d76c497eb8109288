// Every file of api/examples is of its schema, and what the pages read of them is read.
import { readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";
import * as schema from "../../generated/validators";
import { check, type Validator } from "../../shared/messages/check";
import { readStreamMessage } from "../../shared/messages/stream";
import { readModel } from "../../shared/model/readModel";
import { readJson } from "../files";
import { checkExample } from "../schemas";

const folder = new URL("../../../api/examples/", import.meta.url);
const files = readdirSync(fileURLToPath(folder)).filter((name) => name.endsWith(".json"));
const schemaOf = (file: string): string => file.split(".")[0] ?? "";

const by = <T>(validator: Validator<T>) => (value: unknown): T => check(validator, value);

/** How the pages read a message, by its schema. */
const readers: Readonly<Record<string, (value: unknown) => unknown>> = {
  account: by(schema.account),
  account_removed: by(schema.accountRemoved),
  account_tokens: by(schema.accountTokens),
  accounts: by(schema.accounts),
  audit: by(schema.audit),
  empty: by(schema.empty),
  login_answer: by(schema.loginAnswer),
  me: by(schema.me),
  rights: by(schema.rights),
  ticket: by(schema.ticket),
  token_created: by(schema.tokenCreated),
  token_removed: by(schema.tokenRemoved),
  accepted_edit: by(schema.acceptedEdit),
  bundle: by(schema.bundle),
  bundle_installed: by(schema.bundleInstalled),
  cell_pose: by(schema.cellPose),
  control: by(schema.control),
  control_message: by(schema.controlMessage),
  core: by(schema.core),
  core_state: by(schema.coreState),
  cores: by(schema.cores),
  derivations: by(schema.derivations),
  document: (document) => readModel(check(schema.native, { document, origin: {} }).document),
  document_breakpoints: by(schema.documentBreakpoints),
  documents: by(schema.documents),
  errors: by(schema.errors),
  journal: by(schema.journal),
  person: by(schema.person),
  problem: by(schema.problem),
  proposal: by(schema.proposal),
  proposals: by(schema.proposals),
  queue: by(schema.queue),
  queued_run: by(schema.queuedRun),
  rules: by(schema.rules),
  run: by(schema.run),
  run_comparison: by(schema.runComparison),
  runs: by(schema.runs),
  run_picture: by(schema.runPicture),
  run_pictures: by(schema.runPictures),
  samples: by(schema.runSamples),
  scene: by(schema.scene),
  services: by(schema.services),
  stream_message: readStreamMessage,
  task: by(schema.task),
  task_test: by(schema.taskTest),
  test_report: by(schema.testReport),
  timing: by(schema.timing),
  why: by(schema.why),
};

/** Messages that the pages write, and messages between other programs. */
const unread = new Set([
  "account_change", "account_create", "login", "password_change", "token_create",
  "backup", "backups", "boot", "breakpoints", "cell", "checkpoint", "component_message", "component_request",
  "cell_reset", "control_answer", "control_mode", "control_request", "core_confirm_edit", "core_create", "core_load", "core_resume", "core_start", "document_branch", "document_entry", "document_restore", "edit_request",
  "addresses", "pair", "pair_answer", "pairing_create", "pairing_created",
  "service_call", "service_response",
  "operator", "person_command", "proposal_decline", "proposal_request", "queued_run_create", "revisions", "run_file",
  "server_config", "step_request", "stream_request",
]);

describe("api/examples", () => {
  it("are there", () => expect(files.length).toBeGreaterThan(10));
  it.each(files)("%s is of its schema", (file) => {
    expect(checkExample(schemaOf(file), readJson(new URL(file, folder)))).toBeDefined();
  });
  it.each(files.filter((file) => !unread.has(schemaOf(file))))("%s is read", (file) => {
    expect(readers[schemaOf(file)]?.(readJson(new URL(file, folder)))).toBeDefined();
  });
});
