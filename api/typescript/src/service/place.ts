// Where things are declared: FILE:LINE, which editors link.
import { readFileSync } from "node:fs";
import { isAbsolute, relative } from "node:path";
import { fileURLToPath } from "node:url";

export interface Place {
  readonly file: string;
  readonly line: number;
}

/** Some lines of a file. */
export interface Source {
  readonly file: string;
  /** Number of the first of them. */
  readonly first: number;
  readonly lines: readonly string[];
}

/** A file below the folder in which the program runs is named as from there. */
export function placeText({ file, line }: Place): string {
  const path = relative(process.cwd(), file);
  const isBelow = path !== "" && !path.startsWith("..") && !isAbsolute(path);
  return `${isBelow ? path : file}:${line}`;
}

const kFrame = /(file:\/\/.+|\/.+|[A-Z]:\\.+):(\d+):\d+\)?$/;

type Called = ((...given: never[]) => unknown) | (abstract new (...given: never[]) => unknown);

/** Where a function, or the constructor of a class, was called that is under way. Nothing: the stack does not say. */
export function callerOf(called: Called): Place | undefined {
  const held: { stack?: string } = {};
  Error.captureStackTrace(held, called);
  for (const frame of (held.stack ?? "").split("\n")) {
    const [, file, line] = kFrame.exec(frame) ?? [];
    if (file !== undefined) return { file: file.startsWith("file:") ? fileURLToPath(file) : file, line: Number(line) };
  }
  return undefined;
}

function textOf(file: string): string {
  try {
    return readFileSync(file, "utf8");
  } catch {
    return "";
  }
}

/** The lines of the class of an object; what is made of another text, such as TypeScript, has none. `known`: a place in its file. */
export function sourceOf(made: object, known: Place | undefined): Source {
  const { file, line } = known ?? { file: process.argv[1] ?? "?", line: 1 };
  const text = textOf(file);
  const code = made.constructor.toString();
  const at = text.indexOf(code);
  return at < 0 ? { file, first: line, lines: [] } : { file, first: text.slice(0, at).split("\n").length, lines: code.split("\n") };
}

/** The first line that has the name in quotes, or as a key. */
export function placeOf(name: string, { file, first, lines }: Source): Place | undefined {
  if (!/^\w+$/.test(name)) return undefined;
  const named = new RegExp(`(["'\`])${name}\\1|(?<![\\w.$])${name}\\s*:`);
  const at = lines.findIndex((line) => named.test(line));
  return at < 0 ? undefined : { file, line: first + at };
}
