// A folder of programs that have the library as npm installs it: what is compiled, and nothing else.
import { cpSync, existsSync, mkdirSync } from "node:fs";
import { join } from "node:path";
import { project } from "./servers";

export const library = join(project, "api/typescript");

/** The WebSocket of programs before Node 22. */
export const socketPackage = join(project, "web/node_modules/ws");

export function install(folder: string): void {
  if (!existsSync(join(library, "dist/service/index.js"))) throw new Error("run `npm run client` in web/");
  const installed = join(folder, "node_modules/race-client");
  mkdirSync(installed, { recursive: true });
  for (const name of ["package.json", "dist"]) cpSync(join(library, name), join(installed, name), { recursive: true });
}

export function installSocket(folder: string): void {
  cpSync(socketPackage, join(folder, "node_modules/ws"), { recursive: true, dereference: true });
}
