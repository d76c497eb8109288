// What stands at a position of a text: the names of a path, what they mean in a scope, and the call around it.
import { closingOf } from "./brackets";
import type { Name } from "./names";
import type { Scope } from "./scope";
import { fieldsOf } from "./strings";
import { tokensOf, type Token } from "./tokens";

const is = (token: Token | undefined, text: string): boolean => token?.kind === "operator" && token.text === text;
const isWord = (token: Token | undefined): token is Token => token?.kind === "name" || token?.kind === "keyword";

/** The tokens around a position: of the text, or of the expression of a formatted string; nothing in comments and other strings. */
export function tokensAround(text: string, position: number): readonly Token[] | undefined {
  let tokens: readonly Token[] = tokensOf(text);
  for (;;) {
    const inside = tokens.find(({ kind, from, to }) => kind !== "name" && from < position && (position < to || (position === to && kind === "comment")));
    if (inside === undefined || inside.kind === "operator") return tokens;
    const field = inside.kind === "string" ? fieldsOf(text, inside).find(({ from, to }) => from <= position && position <= to) : undefined;
    if (field === undefined) return inside.kind === "keyword" ? tokens : undefined;
    tokens = tokensOf(text, field.from, field.to);
  }
}

/** The words before the dot that stands before the token at `at`, and so on: of `chi.A.res`, at `res`, `chi` and `A`. Nothing behind brackets. */
export function wordsBefore(tokens: readonly Token[], at: number): readonly Token[] | undefined {
  const found: Token[] = [];
  for (let i = at; is(tokens[i - 1], "."); i -= 2) {
    const word = tokens[i - 2];
    if (!isWord(word)) return undefined;
    found.unshift(word);
  }
  return found;
}

const memberOf = (name: Name | undefined, member: string): Name | undefined => name?.members?.().find((each) => each.name === member);

/** What a path means; nothing, if that is not known. */
export function meaningOf({ names }: Scope, path: readonly string[]): Name | undefined {
  const [first, ...rest] = path;
  return rest.reduce<Name | undefined>(memberOf, names.find(({ name }) => name === first));
}

/** The path that is called around the token at `at`; nothing if it stands in no call. */
export function callAround(tokens: readonly Token[], at: number): readonly string[] | undefined {
  for (let open = at - 1; open >= 0; --open) {
    if (!is(tokens[open], "(") || (closingOf(tokens, open) ?? tokens.length) < at) continue;
    const word = tokens[open - 1];
    const before = wordsBefore(tokens, open - 1);
    return isWord(word) && before !== undefined ? [...before, word].map(({ text }) => text) : undefined;
  }
  return undefined;
}

const kAssigning = /^([-+*/%]|\*\*|\/\/)?=$/;

/** The names that a text gives values to. */
export function localNames(text: string): readonly string[] {
  const tokens = tokensOf(text).filter(({ kind }) => kind !== "comment");
  const found = new Set<string>();
  let depth = 0;
  let statement: Token[] = [];
  let isTarget = false;
  tokens.forEach((token, i) => {
    const previous = tokens[i - 1];
    if (depth === 0 && (is(previous, ":") || is(previous, ";") || (previous !== undefined && text.slice(previous.to, token.from).includes("\n")))) statement = [];
    if (token.kind === "operator" && "([{".includes(token.text)) ++depth;
    if (token.kind === "operator" && ")]}".includes(token.text)) depth = Math.max(0, depth - 1);
    if (token.kind === "operator" && depth === 0 && kAssigning.test(token.text)) for (const { text: name } of statement) found.add(name);
    if (token.kind === "keyword" && (token.text === "for" || token.text === "in")) isTarget = token.text === "for";
    if (token.kind !== "name" || is(previous, ".")) return;
    statement.push(token);
    if (isTarget) found.add(token.text);
  });
  return [...found];
}
