// The schemas of api/, gathered: what the pages read and write, and all that these refer to.
import { readdirSync, readFileSync } from "node:fs";

const folder = new URL("../../api/schemas/", import.meta.url);

/** Messages that the pages read. Each gets a validator. */
export const kRead = [
  "accepted_edit.json",
  "account.json",
  "account_removed.json",
  "account_tokens.json",
  "accounts.json",
  "addresses.json",
  "audit.json",
  "cell_pose.json",
  "control.json",
  "control_message.json",
  "core.json",
  "core_delta.json",
  "core_state.json",
  "cores.json",
  "derivations.json",
  "display.json",
  "document_breakpoints.json",
  "document_entry.json",
  "document_removed.json",
  "documents.json",
  "empty.json",
  "errors.json",
  "presence.json#/$defs/presence_delta",
  "presence.json#/$defs/presence_joined",
  "presence.json#/$defs/presence_snapshot",
  "problem.json",
  "proposal.json",
  "proposals.json",
  "health.json",
  "journal.json",
  "login_answer.json",
  "me.json",
  "native.json",
  "packet.json",
  "pair_answer.json",
  "pairing_created.json",
  "past.json",
  "person.json",
  "revisions.json",
  "rights.json",
  "rules.json",
  "run.json",
  "run_picture.json",
  "run_pictures.json",
  "run_comparison.json",
  "run_removed.json",
  "runs.json",
  "samples.json",
  "scene.json",
  "service_response.json",
  "services.json",
  "sounds.json",
  "stream_message.json#/$defs/cores_delta",
  "stream_message.json#/$defs/derivation_position",
  "stream_message.json#/$defs/derivation_steps",
  "stream_message.json#/$defs/document_snapshot",
  "stream_message.json#/$defs/edit_refusal",
  "stream_message.json#/$defs/envelope",
  "stream_message.json#/$defs/log_entries",
  "stream_message.json#/$defs/services_delta",
  "ticket.json",
  "timing.json",
  "token_created.json",
  "token_removed.json",
  "why.json",
];

/** What STOP reads, on each page: validators of their own, as the page on trust is small. */
export const kReadByStop = ["control.json", "problem.json"];

/** Messages that the pages write. */
export const kWritten = ["account_change.json", "account_create.json", "breakpoints.json", "cell_reset.json", "control_answer.json", "control_mode.json", "control_request.json", "core_confirm_edit.json", "core_create.json", "core_resume.json", "core_start.json", "document_branch.json", "document_restore.json", "edit.json", "force.json", "login.json", "pair.json", "pairing_create.json", "password_change.json", "person_command.json", "proposal_decline.json", "service_call.json", "step_request.json", "stream_request.json", "token_create.json"];

/** Names of types that are not the names of their schemas. */
const kNames = new Map([
  ["samples.json", "RunSamples"],
  ["service.json", "Rsm"],
  ["state.json", "RunState"],
]);

/** File name -> schema. */
export function loadSchemas() {
  const files = readdirSync(folder).filter((name) => name.endsWith(".json"));
  return new Map(files.sort().map((name) => [name, JSON.parse(readFileSync(new URL(name, folder), "utf8"))]));
}

/** The address of what `reference` means in the file `base`: a file, with a JSON pointer if it means a part. */
export function resolve(reference, base) {
  const [file, pointer] = reference.split("#");
  return `${file === "" ? base : file}${pointer ? `#${pointer}` : ""}`;
}

/** The schema at an address. */
export function lookUp(schemas, address) {
  const [file, pointer = ""] = address.split("#");
  const found = pointer.split("/").slice(1).reduce((value, key) => value?.[key], schemas.get(file));
  if (found === undefined) throw new Error(`api/schemas has no ${address}`);
  return found;
}

/** `core_delta.json` -> CoreDelta, `core.json#/$defs/fault` -> Fault; nothing of a part that is no definition. */
export function typeName(address) {
  const name = kNames.get(address) ?? /(?:^|\/\$defs\/)(\w+)(?:\.json)?$/.exec(address)?.[1];
  return name?.replace(/(?:^|_)(\w)/g, (_, letter) => letter.toUpperCase());
}

/** `core_delta.json` -> coreDelta. */
export function validatorName(address) {
  const name = typeName(address);
  return name[0].toLowerCase() + name.slice(1);
}

const isObject = (value) => typeof value === "object" && value !== null && !Array.isArray(value);
const mapValues = (object, change) => Object.fromEntries(Object.entries(object).map(([key, value]) => [key, change(value, key)]));

/** A copy of a schema in which `change` has replaced each schema that is an object, from the leaves upwards. */
export function mapSchemas(schema, change) {
  if (!isObject(schema)) return schema;
  const inner = (value) => mapSchemas(value, change);
  return change(
    mapValues(schema, (value, key) => {
      if (key === "properties" || key === "$defs") return mapValues(value, inner);
      return Array.isArray(value) ? value.map(inner) : inner(value);
    }),
  );
}
