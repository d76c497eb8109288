// Validators of the unchanged schemas of api/, which also refuse unknown fields.
import { readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { Ajv2020 } from "ajv/dist/2020.js";
import { check, type Validator } from "../shared/messages/check";
import { readJson } from "./files";

const folder = new URL("../../api/schemas/", import.meta.url);
const ajv = new Ajv2020({ allowUnionTypes: true, inlineRefs: false, strictTypes: false });
for (const file of readdirSync(fileURLToPath(folder))) {
  const schema = readJson(new URL(file, folder));
  if (typeof schema === "object" && schema !== null) ajv.addSchema(schema, file);
}

/** Of a schema that refers to those of api/ by their file names. */
export const compile = <T>(schema: object): Validator<T> => ajv.compile<T>(schema);

/** Throws unless `value` is of `api/schemas/NAME.json`. */
export const checkExample = (name: string, value: unknown): unknown => check(compile<unknown>({ $ref: `${name}.json` }), value);
