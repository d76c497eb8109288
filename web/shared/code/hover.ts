// What is known of the name at a position of a text of code, in lines.
import { detailOf } from "./completion";
import { callAround, localNames, meaningOf, tokensAround, wordsBefore } from "./find";
import { typeText, type Name } from "./names";
import type { Scope } from "./scope";
import type { Span } from "./tokens";

export interface Hover extends Span {
  /** The first says what it is called and which type and unit it has. */
  readonly lines: readonly string[];
}

/** `width: number [m], from 0 to 0.11. Opening of the fingers` */
const argumentLine = (argument: Name): string => [`${argument.name}: ${detailOf(argument)}`, argument.note].filter((part) => part !== undefined).join(", ") + (argument.doc === undefined ? "" : `. ${argument.doc}`);

function linesOf(path: string, name: Name): readonly string[] {
  const head = name.call === undefined ? `${path}: ${detailOf(name)}` : `${path}(${name.call})`;
  const result = name.kind === "operation" ? `result: ${name.type === undefined ? "none" : typeText(name.type)}` : undefined;
  return [head, name.doc, ...(name.parameters ?? []).map(argumentLine), result, name.note].filter((line) => line !== undefined);
}

/** Nothing: nothing is known. */
export function hoverAt(text: string, position: number, scope: Scope): Hover | undefined {
  const tokens = tokensAround(text, position);
  const at = tokens?.findIndex(({ kind, from, to }) => kind === "name" && from <= position && position <= to) ?? -1;
  const token = tokens?.[at];
  const before = tokens && wordsBefore(tokens, at);
  if (tokens === undefined || token === undefined || before === undefined) return undefined;
  const [path, { from, to }] = [[...before, token].map(({ text: word }) => word), token];
  const isNamed = before.length === 0 && tokens[at + 1]?.text === "=";
  const call = isNamed ? callAround(tokens, at) : undefined;
  const argument = call && meaningOf(scope, call)?.parameters?.find(({ name }) => name === token.text);
  if (argument !== undefined) return { from, to, lines: [argumentLine(argument)] };
  const name = meaningOf(scope, path);
  if (name !== undefined) return { from, to, lines: linesOf(path.join("."), name) };
  return before.length === 0 && localNames(text).includes(token.text) ? { from, to, lines: [`${token.text}: of this text alone`] } : undefined;
}
