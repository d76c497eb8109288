// A service as a program, in a folder of its own; what it prints is kept.
import { spawn, type ChildProcess } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { install, installSocket } from "./installed";
import { project, type Server } from "./servers";

/** [ms]; no test needs them. */
const kPatience = 20_000;
const kProgram = join(project, "tests/client/serviceGripper.mjs");

export const programText = readFileSync(kProgram, "utf8");

/** The number of the first line of the program that has this text. */
export const lineOf = (text: string): number => programText.split("\n").findIndex((line) => line.includes(text)) + 1;

/** Until it holds. */
export async function eventually(holds: () => boolean | Promise<boolean>, what: () => string = () => "it does not come to that"): Promise<void> {
  for (const end = Date.now() + kPatience; !(await holds()); await new Promise((resolve) => setTimeout(resolve, 20))) {
    if (Date.now() > end) throw new Error(what());
  }
}

export class Program {
  readonly file: string;
  said = "";
  private child: ChildProcess | undefined;

  constructor(
    private readonly server: Server,
    text: string = programText,
  ) {
    const folder = mkdtempSync(join(tmpdir(), "race-service-"));
    this.file = join(folder, "gripper.mjs");
    install(folder);
    installSocket(folder);
    cpSync(join(project, "tests/integration/patience.rsm.json"), join(folder, "patience.rsm.json"));
    this.save(text);
  }

  get folder(): string {
    return join(this.file, "..");
  }

  save(text: string): void {
    writeFileSync(this.file, text);
  }

  /** As many editors save. */
  replace(text: string): void {
    writeFileSync(`${this.file}.new`, text);
    renameSync(`${this.file}.new`, this.file);
  }

  /** `options`: of the program. */
  start({ options = [] }: { readonly options?: readonly string[] } = {}): this {
    const { RACE_TOKEN: _, ...env } = process.env;
    const words = [this.file, "--server", this.server.url, "--token-file", join(this.server.data, "processes.token"), ...options];
    // `--reload` has a process of its own for the program; a group ends as a whole.
    this.child = spawn(process.execPath, words, { cwd: this.folder, env, detached: true, stdio: ["ignore", "pipe", "pipe"] });
    for (const stream of [this.child.stdout, this.child.stderr]) stream?.on("data", (data: Buffer) => (this.said += data.toString()));
    return this;
  }

  async waitFor(pattern: RegExp, count = 1): Promise<void> {
    const global = new RegExp(pattern.source, "g");
    await eventually(() => [...this.said.matchAll(global)].length >= count, () => `no ${pattern.source} in: ${this.said}`);
  }

  /** Its exit status, once it has ended by itself. */
  async ended(): Promise<number | null> {
    const { child } = this;
    if (child === undefined) return null;
    await eventually(() => child.exitCode !== null || child.signalCode !== null, () => `it goes on: ${this.said}`);
    return child.exitCode;
  }

  /** Its exit status after the signal. */
  async end(signal: NodeJS.Signals = "SIGTERM"): Promise<number | null> {
    this.child?.kill(signal);
    return await this.ended();
  }

  /** It and its folder are gone. */
  remove(): void {
    try {
      if (this.child?.pid !== undefined) process.kill(-this.child.pid, "SIGKILL");
    } catch {
      // It has ended.
    }
    rmSync(this.folder, { recursive: true, force: true });
  }
}

/** A task that makes one call: `result` with its value, or `error` with the error. */
export function calling(call: string, name = "calling"): { readonly name: string } {
  const [answer = ""] = call.split("(");
  const available = (result: string) => ({ name: result, when: `available(res.${result === "result" ? "value" : "error"})` });
  const root = {
    state: "Root",
    entry: call,
    results: [{ name: "value" }, { name: "error" }],
    actions: [
      { when: `${answer}.result`, do: `res.value = ${answer}.result` },
      { when: `${answer}.error`, do: `res.error = ${answer}.error` },
    ],
    ports: [available("result"), available("error")],
  };
  return { rcm: 1, name, root } as { readonly name: string };
}
