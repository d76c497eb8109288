import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

export function readJson(url: URL): unknown {
  return JSON.parse(readFileSync(fileURLToPath(url), "utf8"));
}
