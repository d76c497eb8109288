// main.mjs NODE_MODULES FOLDER: checks the contract in FOLDER (openapi.yaml, asyncapi.yaml and schemas/) with the packages of
// NODE_MODULES. Prints a line for each finding; status 1 if there are any. That the server does what the contract says, and that
// api/examples are of their schemas, is what the tests hold.
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { checkAsyncapi } from "./asyncapi.mjs";
import { checkOpenapi } from "./openapi.mjs";
import { loadSchemas } from "./schemas.mjs";

const [modules, folder] = process.argv.slice(2);
const load = createRequire(join(resolve(modules), "package.json"));

const { validatorOf, findings } = loadSchemas(load, folder);
findings.push(...(await checkOpenapi(load, folder)), ...checkAsyncapi(load, folder, validatorOf));
const lines = findings.map(({ file, at, rule, message }) => `${join(folder, file)}${at === undefined ? "" : `:${at.line}:${at.col}`}: ${rule}: ${message}`);
for (const line of new Set(lines)) console.log(line);
process.exitCode = lines.length > 0 ? 1 : 0;
