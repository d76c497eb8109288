// ruff.mjs NODE_MODULES FILE...: checks Python files with Ruff's WebAssembly build and options.json. Prints a line for each
// finding; status 1 if there are any. Not asked for: E731 (short named predicates read well), RUF012 (constants of a test class),
// SIM117 (nested blocks show what lives how long).
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";

const [modules, ...files] = process.argv.slice(2);
const { PositionEncoding, Workspace } = createRequire(import.meta.url)(resolve(modules, "@astral-sh/ruff-wasm-nodejs"));
const options = JSON.parse(readFileSync(new URL("options.json", import.meta.url), "utf8"));
const workspace = new Workspace(options, PositionEncoding.Utf32);

let findings = 0;
for (const file of files) {
  for (const { code, message, start_location: at } of workspace.check(readFileSync(file, "utf8"))) {
    console.log(`${file}:${at.row}:${at.column}: ${code ?? "syntax"}: ${message}`);
    findings += 1;
  }
}
process.exitCode = findings > 0 ? 1 : 0;
