// Brackets of a text: which token closes which, and the parts of a range that commas or keywords separate.
import type { Token } from "./tokens";

const kClosing: Readonly<Record<string, string>> = { "(": ")", "[": "]", "{": "}" };

export const isOpening = ({ kind, text }: Token): boolean => kind === "operator" && Object.hasOwn(kClosing, text);
const isClosing = ({ kind, text }: Token): boolean => kind === "operator" && (text === ")" || text === "]" || text === "}");

/** The index of the token that closes the bracket at `open`; nothing if none does. */
export function closingOf(tokens: readonly Token[], open: number): number | undefined {
  let depth = 0;
  for (let i = open; i < tokens.length; ++i) {
    const token = tokens[i];
    if (token === undefined) return undefined;
    if (isOpening(token)) ++depth;
    if (isClosing(token) && --depth === 0) return i;
  }
  return undefined;
}

/** `tokens` between those that are `separator` and stand in no bracket. */
export function splitBy(tokens: readonly Token[], separator: string): readonly (readonly Token[])[] {
  const parts: Token[][] = [[]];
  let depth = 0;
  for (const token of tokens) {
    if (isOpening(token)) ++depth;
    if (isClosing(token)) --depth;
    if (depth === 0 && token.text === separator && token.kind !== "string") parts.push([]);
    else parts.at(-1)?.push(token);
  }
  return parts;
}
