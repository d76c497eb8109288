// The page of api/templates/gripper_typescript, followed literally: its commands do and print what it says. Only the port is another one, and `ws` is that of web/.
import { spawn, spawnSync, type ChildProcess } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, realpathSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { socketPackage } from "./installed";
import { binary, project, Server } from "./servers";
import { eventually } from "./serviceProgram";

const template = join(project, "api/templates/gripper_typescript");
const kFence = "```";
const kOwnTerminal = "In a terminal of its own:";

interface Block {
  /** The line before; its fence, of one that follows another at once. */
  readonly before: string;
  readonly kind: string;
  readonly text: string;
}

function blocksOf(page: string): readonly Block[] {
  const found: Block[] = [];
  let before = "";
  let open: { readonly kind: string; readonly lines: string[] } | undefined;
  for (const line of page.split("\n")) {
    if (open === undefined && line.startsWith(kFence)) open = { kind: line.slice(kFence.length), lines: [] };
    else if (open === undefined) before = line === "" ? before : line;
    else if (line !== kFence) open.lines.push(line);
    else {
      found.push({ before, kind: open.kind, text: open.lines.join("\n") });
      [before, open] = [kFence, undefined];
    }
  }
  return found;
}

/** Somebody who follows the page in a folder that looks like a checkout. */
class Reader {
  readonly folder = mkdtempSync(join(tmpdir(), "race-reader-"));
  shown = "";
  private read = 0;
  private terminal: ChildProcess | undefined;

  constructor(private readonly server: Server) {
    mkdirSync(join(this.folder, "build/release"), { recursive: true });
    symlinkSync(realpathSync(binary), join(this.folder, "build/release/race"));
    symlinkSync(join(project, "api"), join(this.folder, "api"));
    symlinkSync(server.data, join(this.folder, "data"));
  }

  /** What a command prints that ends. */
  done(command: string): string {
    const { status, stdout, stderr } = spawnSync("bash", ["-c", this.here(command)], { ...this.options(), encoding: "utf8", timeout: 60_000 });
    expect([status, stderr], command).toEqual([0, ""]);
    return stdout;
  }

  inOwnTerminal(command: string): void {
    this.terminal = spawn("bash", ["-c", this.here(command)], { ...this.options(), detached: true, stdio: ["ignore", "pipe", "pipe"] });
    for (const stream of [this.terminal.stdout, this.terminal.stderr]) stream?.on("data", (data: Buffer) => (this.shown += data.toString()));
  }

  /** Until its terminal shows it, below what was waited for before. Calls are numbered over all services. */
  async shows(text: string): Promise<void> {
    const pattern = new RegExp(escaped(text).replace(/call \d+/, "call \\d+"), "g");
    await eventually(() => {
      pattern.lastIndex = this.read;
      return pattern.test(this.shown);
    }, () => `no ${text} in: ${this.shown}`);
    this.read = pattern.lastIndex;
  }

  /** Ctrl-C in its terminal; all is gone. */
  async leave(): Promise<void> {
    const { terminal } = this;
    if (terminal?.pid !== undefined) {
      process.kill(-terminal.pid, "SIGINT");
      await eventually(() => terminal.exitCode !== null || terminal.signalCode !== null, () => this.shown);
    }
    rmSync(this.folder, { recursive: true, force: true });
  }

  private options() {
    const { RACE_TOKEN: _, ...env } = process.env;
    return { cwd: this.folder, env };
  }

  private here(command: string): string {
    return command
      .replace("npm install ../api/typescript ws", `npm install --offline --no-audit --no-fund --loglevel=error ../api/typescript ${socketPackage} >/dev/null`)
      .replace(/^(.*race call .*|node .*)$/gm, `$1 --server ${this.server.url}`);
  }
}

const escaped = (text: string): string => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");

describe("the template", () => {
  it("the page of the template does what it says", async () => {
    const blocks = blocksOf(readFileSync(join(template, "README.md"), "utf8"));
    expect(blocks.map(({ kind }) => kind)).toEqual(["sh", "sh", "text", "sh", "text", "sh", "text", "sh", "text", "sh", "text", "text"]);
    const server = await Server.start(["--demo", join(project, "deploy/demo")]);
    const reader = new Reader(server);
    let said = "";
    try {
      for (const { before, kind, text } of blocks) {
        if (kind === "sh" && before === kOwnTerminal) reader.inOwnTerminal(text);
        else if (kind === "sh") said = reader.done(text);
        else if (before === kFence) expect(said.trimEnd()).toBe(text);
        else await reader.shows(text);
      }
    } finally {
      await reader.leave();
      await server.stop();
    }
  });

  it("the template has less than 30 lines", () => {
    expect(readFileSync(join(template, "gripper.mjs"), "utf8").trimEnd().split("\n").length).toBeLessThan(30);
  });
});
