// The tokens of the function language (core/language/syntax/lexer.cpp), read so that any text has some: what is no token is `wrong`.
import { kKeywords } from "./words";

export type TokenKind = "name" | "keyword" | "number" | "string" | "comment" | "operator" | "wrong";

/** A range of a text: offsets in UTF-16 units, as in JavaScript's strings. */
export interface Span {
  readonly from: number;
  readonly to: number;
}

export interface Token extends Span {
  readonly kind: TokenKind;
  readonly text: string;
}

const kKeywordSet: ReadonlySet<string> = new Set(kKeywords);

/** The prefix and the opening quotes of a string. */
const kStringStart = /^([rRuUfFbB]|[fFbB][rR]|[rR][fFbB])?('''|"""|'|")/;

/** What begins a token; `wrong` is the rest, one character each. Spaces and line ends are between tokens. */
const kToken = /(?<comment>#[^\n]*)|(?<number>0[xX][\da-fA-F_]+|0[oO][0-7_]+|0[bB][01_]+|(?:\d[\d_]*\.?[\d_]*|\.\d[\d_]*)(?:[eE][+-]?\d[\d_]*)?)|(?<word>[A-Za-z_]\w*)|(?<operator>\*\*=?|\/\/=?|[-+*/%=!<>]=|[-+*/%<>=()[\]{},:.;])|(?<wrong>\S)/y;

/** Where the string ends whose opening quotes stand before `from`; at the end of the line or text if it is not closed. */
function endOfString(text: string, from: number, quotes: string): { readonly to: number; readonly isClosed: boolean } {
  for (let at = from; at < text.length; ++at) {
    if (text.startsWith(quotes, at)) return { to: at + quotes.length, isClosed: true };
    if (text[at] === "\n" && quotes.length === 1) return { to: at, isClosed: false };
    if (text[at] === "\\") ++at;
  }
  return { to: text.length, isClosed: false };
}

function wordKind(word: string): TokenKind {
  return kKeywordSet.has(word) ? "keyword" : "name";
}

function tokenAt(text: string, from: number): Token | undefined {
  const quoted = kStringStart.exec(text.slice(from, from + 5));
  if (quoted !== null) {
    const { to, isClosed } = endOfString(text, from + quoted[0].length, quoted[2] ?? "");
    return { kind: isClosed ? "string" : "wrong", from, to, text: text.slice(from, to) };
  }
  kToken.lastIndex = from;
  const found = kToken.exec(text);
  if (found === null) return undefined;
  const [word] = found;
  const kind = (["comment", "number", "operator", "wrong"] as const).find((each) => found.groups?.[each] !== undefined) ?? wordKind(word);
  return { kind, from, to: from + word.length, text: word };
}

/** The tokens of `text` between two offsets, in order; comments are among them. */
export function tokensOf(text: string, from = 0, to = text.length): readonly Token[] {
  const part = text.slice(0, to);
  const found: Token[] = [];
  for (let at = from; at < to; ) {
    const token = /\s/.test(part[at] ?? "") ? undefined : tokenAt(part, at);
    if (token !== undefined) found.push(token);
    at = token?.to ?? at + 1;
  }
  return found;
}
