// The schemas of api/, gathered: what clients read and write, and all that these refer to.
import { readdirSync, readFileSync } from "node:fs";

const folder = new URL("../../api/schemas/", import.meta.url);

/** Of the routes: schemas of what they answer, and of what they are sent. */
const routes = JSON.parse(readFileSync(new URL("../../api/typescript/messages.json", import.meta.url), "utf8"));

/** Messages that clients read. Each gets a validator. */
export const kRead = [
  ...routes.read,
  "cell_pose.json",
  "control_message.json",
  "core_delta.json",
  "display.json",
  "errors.json",
  "presence.json#/$defs/presence_delta",
  "presence.json#/$defs/presence_joined",
  "presence.json#/$defs/presence_snapshot",
  "problem.json",
  "packet.json",
  "rights.json",
  "sounds.json",
  "stream_message.json#/$defs/cores_delta",
  "stream_message.json#/$defs/derivation_position",
  "stream_message.json#/$defs/derivation_steps",
  "stream_message.json#/$defs/document_snapshot",
  "stream_message.json#/$defs/edit_refusal",
  "stream_message.json#/$defs/envelope",
  "stream_message.json#/$defs/log_entries",
  "stream_message.json#/$defs/services_delta",
  "test_report.json",
];

/** What STOP reads, on each page: validators of their own, as the page on trust is small. */
export const kReadByStop = ["control.json", "problem.json"];

/** Messages that clients write. */
export const kWritten = [...routes.written, "control_request.json", "edit.json", "stream_request.json"];

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
