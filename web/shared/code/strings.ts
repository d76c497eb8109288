// String literals: what they say, and the expressions in those that are formatted.
import type { Span, Token } from "./tokens";

const kStart = /^([A-Za-z]*)('''|"""|'|")/;

interface Parts {
  readonly prefix: string;
  readonly body: Span;
}

function partsOf(token: Token): Parts {
  const [all = "", prefix = "", quotes = ""] = kStart.exec(token.text) ?? [];
  return { prefix: prefix.toLowerCase(), body: { from: token.from + all.length, to: token.to - quotes.length } };
}

const kEscapes: Readonly<Record<string, string>> = { "\\": "\\", "'": "'", '"': '"', a: "\x07", b: "\b", f: "\f", n: "\n", r: "\r", t: "\t", v: "\v", "\n": "" };
const kEscape = /\\(?:([0-7]{1,3})|x([\da-fA-F]{2})|u([\da-fA-F]{4})|U([\da-fA-F]{8})|\r?(\n)|([\\'"abfnrtv]))/g;

const unescaped = (body: string): string =>
  body.replace(kEscape, (_, octal?: string, x?: string, u?: string, U?: string, line?: string, letter?: string) => {
    const hex = x ?? u ?? U;
    if (octal !== undefined) return String.fromCodePoint(parseInt(octal, 8));
    if (hex !== undefined) return String.fromCodePoint(Math.min(parseInt(hex, 16), 0x10ffff));
    return kEscapes[letter ?? line ?? ""] ?? "";
  });

/** The text that a literal is; nothing if it is formatted. */
export function literalText(token: Token): string | undefined {
  const { prefix, body } = partsOf(token);
  if (prefix.includes("f")) return undefined;
  const text = token.text.slice(body.from - token.from, body.to - token.from);
  return prefix.includes("r") ? text : unescaped(text);
}

/** Where the expression that begins at `from` ends: before `}`, `:`, `!`, or an `=` that compares nothing. */
function endOfField(text: string, from: number, to: number): number {
  let depth = 0;
  let quote = "";
  for (let at = from; at < to; ++at) {
    const c = text[at] ?? "";
    if (quote !== "") quote = c === quote ? "" : quote;
    else if (c === "'" || c === '"') quote = c;
    else if ("([{".includes(c)) ++depth;
    else if (depth > 0) depth -= ")]}".includes(c) ? 1 : 0;
    else if ("!=<>".includes(c) && text[at + 1] === "=") ++at;
    else if ("}:!=".includes(c)) return at;
  }
  return to;
}

function fieldsIn(text: string, { from, to }: Span, level: number): readonly Span[] {
  const found: Span[] = [];
  for (let at = from; at < to; ++at) {
    const c = text[at];
    if (level > 0 && c === "}") return found;
    if (c === "\\") ++at;
    else if ((c === "{" || c === "}") && level === 0 && text[at + 1] === c) ++at;
    else if (c === "{" && level < 2) {
      const end = endOfField(text, at + 1, to);
      found.push({ from: at + 1, to: end });
      const format = text.indexOf(":", end);
      const close = text.indexOf("}", end);
      if (close < 0) return found;
      at = format >= 0 && format < close ? endOfFormat(text, format + 1, to) : close;
      if (at > close || (format >= 0 && format < close)) found.push(...fieldsIn(text, { from: format + 1, to: at }, level + 1));
    }
  }
  return found;
}

/** Where the format that begins at `from` ends: at its `}`, behind those of the fields in it. */
function endOfFormat(text: string, from: number, to: number): number {
  let depth = 0;
  for (let at = from; at < to; ++at) {
    if (text[at] === "{") ++depth;
    if (text[at] === "}" && depth-- === 0) return at;
  }
  return to;
}

/** The expressions in a formatted literal (`f"{...}"`) of `text`. */
export function fieldsOf(text: string, token: Token): readonly Span[] {
  const { prefix, body } = partsOf(token);
  return prefix.includes("f") ? fieldsIn(text, body, 0) : [];
}
