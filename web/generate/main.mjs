// Makes api/typescript/src/generated/ from api/schemas: types of all messages of clients, validators of those that they read; and web/generated/,
// which has them for the pages, and what is of the pages alone.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { kRead, kReadByStop, kWritten, loadSchemas } from "./schemas.mjs";
import { typesOf } from "./types.mjs";
import { declarationsOf, validatorsOf } from "./validators.mjs";

const client = new URL("../../api/typescript/src/generated/", import.meta.url);
const pages = new URL("../generated/", import.meta.url);
const kClient = "../../api/typescript/src/generated";
const kHeader = "// Made from api/schemas by `npm run generate` in web/.\n";

/** A file that is as it should be keeps its time. */
function write(folder, name, text) {
  const url = new URL(name, folder);
  if (!existsSync(url) || readFileSync(url, "utf8") !== kHeader + text) writeFileSync(url, kHeader + text);
}

const schemas = loadSchemas();
for (const folder of [client, pages]) mkdirSync(folder, { recursive: true });
write(client, "messages.ts", `import type { JsonValue } from "../json.js";\n\n${await typesOf(schemas, [...kRead, ...kWritten])}`);
write(client, "validators.js", validatorsOf(schemas, kRead));
write(client, "validators.d.ts", declarationsOf(kRead, "../check.js", "./messages.js"));
write(pages, "messages.ts", `export type * from "${kClient}/messages";\n`);
for (const name of ["validators.js", "validators.d.ts"]) write(pages, name, `export * from "${kClient}/validators.js";\n`);
write(pages, "stopValidators.js", validatorsOf(schemas, kReadByStop));
write(pages, "stopValidators.d.ts", declarationsOf(kReadByStop, "../shared/messages/check", "./messages"));
