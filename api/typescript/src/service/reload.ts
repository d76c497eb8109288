// A program that begins anew whenever a file beside it is saved. On Linux, `node --watch` does not see a file again that was replaced, as
// many editors save.
import { spawn, spawnSync, type ChildProcess } from "node:child_process";
import { readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, extname, join } from "node:path";
import type { Log } from "./hosted.js";
import { pause } from "../limits.js";
import { placeText } from "./place.js";
import { messageOf } from "./values.js";

export const kReload = "reload";
/** [s] between looks at the files. */
const kLook = 0.2;
/** [s] for the program to end. */
const kEndTime = 5;
const kPrograms: readonly string[] = [".js", ".mjs", ".cjs"];
/** The end of the name of a file with a task, which is none of the program's; nor is what is hidden: `race push` writes both. */
const kTask = ".rcm.json";

/** By file: when it was saved, and how long it is. */
type Stamps = ReadonlyMap<string, string>;

function stampOf(file: string): readonly (readonly [string, string])[] {
  try {
    const { mtimeMs, size } = statSync(file);
    return [[file, `${mtimeMs} ${size}`]];
  } catch {
    return []; // it is being replaced
  }
}

function stampsOf(folder: string): Stamps {
  const names = readdirSync(folder).filter((name) => [...kPrograms, ".json"].includes(extname(name)) && !name.endsWith(kTask) && !name.startsWith("."));
  return new Map(names.sort().flatMap((name) => stampOf(join(folder, name))));
}

/** FILE:LINE and what is wrong with it; nothing: no error of syntax. */
function slipOf(file: string): string | undefined {
  const slip = (line: number, message: string) => `${placeText({ file, line })}: error: ${message}; what was saved before goes on`;
  if (kPrograms.includes(extname(file))) {
    const { status, stderr } = spawnSync(process.execPath, ["--check", file], { encoding: "utf8" });
    const [, line = "1"] = /:(\d+)$/m.exec(stderr) ?? [];
    return status === 0 ? undefined : slip(Number(line), /^\w*Error: .*$/m.exec(stderr)?.[0] ?? "it has an error of syntax");
  }
  try {
    JSON.parse(readFileSync(file, "utf8"));
    return undefined;
  } catch (error) {
    return slip(1, messageOf(error));
  }
}

const isOver = ({ exitCode, signalCode }: ChildProcess): boolean => exitCode !== null || signalCode !== null;

async function end(child: ChildProcess): Promise<void> {
  child.kill("SIGTERM");
  for (let waited = 0; !isOver(child) && waited < kEndTime; waited += 0.02) await pause(0.02);
  if (!isOver(child)) child.kill("SIGKILL");
}

/** It may be meanwhile, which a compiler does not see. */
const isAborted = (signal: AbortSignal): boolean => signal.aborted;

/** Runs this program without --reload, again whenever a file of its folder is saved, until `signal` is aborted. */
export async function runAnewWhenSaved(signal: AbortSignal, show: Log): Promise<void> {
  const words = [...process.execArgv, ...process.argv.slice(1).filter((word) => word !== `--${kReload}`)];
  const folder = dirname(process.argv[1] ?? ".");
  let stamps = stampsOf(folder);
  while (!signal.aborted) {
    const child = spawn(process.execPath, words, { stdio: "inherit" });
    stamps = await changed(folder, stamps, child, signal, show);
    await end(child);
    if (!isAborted(signal)) show("saved: begins anew");
  }
}

/** Once something was saved that can be run, or the signal is aborted: the stamps of what runs then. */
async function changed(folder: string, before: Stamps, child: ChildProcess, signal: AbortSignal, show: Log): Promise<Stamps> {
  let stamps = before;
  let hasEnded = false;
  let wrong: readonly string[] = [];
  while (!signal.aborted) {
    await pause(kLook);
    if (!hasEnded && isOver(child)) {
      hasEnded = true;
      show(`it has ended with status ${child.exitCode ?? child.signalCode ?? 0}; it begins anew when a file is saved`);
    }
    const now = stampsOf(folder);
    const saved = [...now].filter(([file, stamp]) => stamps.get(file) !== stamp).map(([file]) => file);
    const isSame = saved.length === 0 && now.size === stamps.size;
    stamps = now;
    if (isSame) continue;
    const slips = new Map([...new Set([...wrong, ...saved])].filter((file) => now.has(file)).map((file) => [file, slipOf(file)]));
    wrong = [...slips.keys()].filter((file) => slips.get(file) !== undefined);
    if (wrong.length === 0) return stamps;
    show(wrong.map((file) => slips.get(file)).join("\n"));
  }
  return stamps;
}
