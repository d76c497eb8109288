// Makes web/generated/ from api/schemas: types of all messages of the pages, validators of those that they read.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { kRead, kReadByStop, kWritten, loadSchemas } from "./schemas.mjs";
import { typesOf } from "./types.mjs";
import { declarationsOf, validatorsOf } from "./validators.mjs";

const output = new URL("../generated/", import.meta.url);
const kHeader = "// Made from api/schemas by `npm run generate`.\n";

/** A file that is as it should be keeps its time. */
function write(name, text) {
  const url = new URL(name, output);
  if (!existsSync(url) || readFileSync(url, "utf8") !== text) writeFileSync(url, text);
}

const schemas = loadSchemas();
mkdirSync(output, { recursive: true });
write("messages.ts", `${kHeader}import type { JsonValue } from "../shared/json";\n\n${await typesOf(schemas, [...kRead, ...kWritten])}`);
write("validators.js", kHeader + validatorsOf(schemas, kRead));
write("validators.d.ts", kHeader + declarationsOf(kRead));
write("stopValidators.js", kHeader + validatorsOf(schemas, kReadByStop));
write("stopValidators.d.ts", kHeader + declarationsOf(kReadByStop));
