// schemas/*.json: JSON Schemas of the dialect 2020-12 without unknown keywords and formats, each with the `$id` of its file, that find
// what they refer to.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { unresolvedIn } from "./references.mjs";

const kDialect = "https://json-schema.org/draft/2020-12/schema";
const kAddress = "https://race.invalid/schemas/";

/** The findings in FOLDER/schemas, and `validatorOf`: of an address as "core.json#/$defs/fault", if there is one without findings. */
export function loadSchemas(load, folder) {
  const { Ajv2020 } = load("ajv/dist/2020.js");
  // Not the strictness about types and required properties: an alternative of an object says what differs, and no more.
  const ajv = new Ajv2020({ allErrors: true, allowUnionTypes: true, inlineRefs: false, logger: false, strictTuples: true, strictTypes: false });
  const schemas = join(folder, "schemas");
  const findings = [];
  const names = [];
  const add = (name, rule, message) => findings.push({ file: join("schemas", name), rule, message });
  const attempt = (name, action) => {
    try {
      return action();
    } catch (error) {
      add(name, "json-schema", error.message);
      return undefined;
    }
  };
  for (const name of readdirSync(schemas).sort()) {
    const schema = attempt(name, () => JSON.parse(readFileSync(join(schemas, name), "utf8")));
    if (schema === undefined) continue;
    if (schema.$schema !== kDialect) add(name, "dialect", `$schema must be ${kDialect}`);
    if (schema.$id !== kAddress + name) add(name, "address", `$id must be ${kAddress}${name}`);
    for (const { path, target } of unresolvedIn(schema, schemas)) add(name, "reference", `there is no ${target} (#/${path.join("/")})`);
    attempt(name, () => ajv.addSchema({ ...schema, $id: kAddress + name }));
    names.push(name, ...Object.keys(schema.$defs ?? {}).map((part) => `${name}#/$defs/${part}`));
  }
  // A part that nothing refers to is compiled by itself alone.
  const validators = new Map(names.map((address) => [address, attempt(address.split("#")[0], () => ajv.getSchema(kAddress + address))]));
  return { validatorOf: (address) => validators.get(address), findings };
}
