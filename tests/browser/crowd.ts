// Clients of a document, each a process of its own (crowdClient.ts, bundled).
import { spawn, spawnSync, type ChildProcess } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import type { CrowdCommand, CrowdReport, CrowdSetup } from "./crowdClient";
import { project } from "./fixture";

type ReportOf<T extends CrowdReport["type"]> = Extract<CrowdReport, { readonly type: T }>;

export interface CrowdClient {
  /** Its next report, which is of this type. */
  readonly report: <T extends CrowdReport["type"]>(type: T) => Promise<ReportOf<T>>;
  readonly command: (command: CrowdCommand) => void;
}

export interface Crowd {
  readonly open: (setup: CrowdSetup) => CrowdClient;
  readonly close: () => void;
}

function clientOf(child: ChildProcess, name: string): CrowdClient {
  const reports: CrowdReport[] = [];
  let wake: () => void = () => undefined;
  let ended = false;
  if (child.stdout === null || child.stdin === null) throw new Error("the client has no pipes");
  createInterface({ input: child.stdout }).on("line", (line) => {
    reports.push(JSON.parse(line) as CrowdReport);
    wake();
  });
  child.on("exit", () => {
    ended = true;
    wake();
  });
  const { stdin } = child;
  return {
    command: (command) => void stdin.write(`${JSON.stringify(command)}\n`),
    report: async <T extends CrowdReport["type"]>(type: T) => {
      while (reports.length === 0 && !ended) await new Promise<void>((resolve) => (wake = resolve));
      const next = reports.shift();
      if (next?.type !== type) throw new Error(`${name}: expected ${type}, got ${next?.type ?? "its end"}`);
      return next as ReportOf<T>;
    },
  };
}

export function openCrowd(): Crowd {
  const folder = mkdtempSync(join(tmpdir(), "race-crowd-"));
  const program = join(folder, "client.mjs");
  const bundled = spawnSync(join(project, "web/node_modules/.bin/esbuild"), [join(project, "tests/browser/crowdClient.ts"), "--bundle", "--platform=node", "--format=esm", "--log-level=warning", `--outfile=${program}`], { encoding: "utf8" });
  if (bundled.status !== 0) throw new Error(bundled.stderr);
  const children: ChildProcess[] = [];
  return {
    open: (setup) => {
      const child = spawn(process.execPath, [program, JSON.stringify(setup)], { stdio: ["pipe", "pipe", "inherit"] });
      children.push(child);
      return clientOf(child, setup.name);
    },
    close: () => {
      children.forEach((child) => child.kill("SIGKILL"));
      rmSync(folder, { recursive: true });
    },
  };
}
