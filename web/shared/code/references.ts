// References: where a text names what belongs to its state, its children and services, as core/edit/references.h finds them. Of a text that
// cannot be parsed, too: what can be seen of it.
import { closingOf } from "./brackets";
import { fieldsOf, literalText } from "./strings";
import { tokensOf, type Span, type Token } from "./tokens";
import { isCollection } from "./words";

/** One path in a text: `chi.A.res.x`, `par["x"]`, `var.get("x")`, `"x" in res`, `svc["S"].op`. */
export interface Reference {
  /** The first is par, res, var, port, chi or svc; that alone: the collection as a whole. */
  readonly names: readonly string[];
  /** Of each name; of one that stands as a text, of the literal. */
  readonly spans: readonly Span[];
}

const isOwn = (name: string): boolean => name === "par" || name === "res" || name === "var";
const isText = (token: Token | undefined): token is Token => token?.kind === "string" && literalText(token) !== undefined;
const is = (token: Token | undefined, text: string): boolean => token?.kind === "operator" && token.text === text;

const reference = (...tokens: readonly Token[]): Reference => ({ names: tokens.map((token) => (token.kind === "string" ? (literalText(token) ?? "") : token.text)), spans: tokens.map(({ from, to }) => ({ from, to })) });

/** `.a.b` from the token `at` on. */
function attributes(tokens: readonly Token[], at: number): readonly Token[] {
  const found: Token[] = [];
  for (let i = at; is(tokens[i], "."); i += 2) {
    const name = tokens[i + 1];
    if (name?.kind !== "name") break;
    found.push(name);
  }
  return found;
}

/** The path that begins with the collection at `at`. */
function pathAt(tokens: readonly Token[], at: number, root: Token): Reference | undefined {
  const [next, inner, after] = [tokens[at + 1], tokens[at + 2], tokens[at + 3]];
  if (is(next, "[") && root.text === "svc") {
    if (!isText(inner) || !is(after, "]")) return undefined; // a service that is found while it runs
    return reference(root, inner, ...attributes(tokens, at + 4));
  }
  if (is(next, "[") && isOwn(root.text) && isText(inner) && is(after, "]")) return reference(root, inner);
  const names = attributes(tokens, at + 1);
  const behind = at + 1 + 2 * names.length;
  const [method] = names;
  if (!isOwn(root.text) || names.length !== 1 || !is(tokens[behind], "(")) return reference(root, ...names);
  const [key, end] = [tokens[behind + 1], tokens[behind + 2]];
  return method?.text === "get" && isText(key) && (is(end, ",") || is(end, ")")) ? reference(root, key) : reference(root);
}

/** What binds more than `in`, so that a text or collection beside it is not what is compared. */
const kBinding: ReadonlySet<string> = new Set(["+", "-", "*", "/", "//", "%", "**", ".", "[", "("]);

/** The text in `"x" in par`, where `par` is at `at`. */
function keyBefore(tokens: readonly Token[], at: number): Token | undefined {
  const isIn = tokens[at - 1]?.text === "in";
  const key = tokens[at - (tokens[at - 2]?.text === "not" ? 3 : 2)];
  const before = key && tokens[tokens.indexOf(key) - 1];
  const [behind] = tokens.slice(at + 1);
  const binds = (token: Token | undefined, but: string): boolean => token?.kind === "operator" && kBinding.has(token.text) && !but.includes(token.text);
  return isIn && isText(key) && !binds(before, "([") && !binds(behind, "") ? key : undefined;
}

/** Whether the name at `at` is that of an argument: `f(par=1)`. */
function isArgumentName(tokens: readonly Token[], at: number): boolean {
  return is(tokens[at + 1], "=") && (is(tokens[at - 1], "(") || is(tokens[at - 1], ",")) && isInCall(tokens, at);
}

function isInCall(tokens: readonly Token[], at: number): boolean {
  for (let i = at - 1; i >= 0; --i) if (is(tokens[i], "(") && (closingOf(tokens, i) ?? tokens.length) > at) return true;
  return false;
}

/** The references in a text, or in a range of it, in order. */
export function referencesIn(text: string, from = 0, to = text.length): readonly Reference[] {
  const tokens = tokensOf(text, from, to).filter(({ kind }) => kind !== "comment");
  return tokens.flatMap((token, at): readonly Reference[] => {
    if (token.kind === "string") return fieldsOf(text, token).flatMap((field) => referencesIn(text, field.from, field.to));
    if (token.kind !== "name" || !isCollection(token.text) || is(tokens[at - 1], ".") || isArgumentName(tokens, at)) return [];
    const key = isOwn(token.text) ? keyBefore(tokens, at) : undefined;
    const path = pathAt(tokens, at, token);
    return [...(key === undefined ? [] : [reference(token, key)]), ...(path === undefined ? [] : [path])];
  });
}

/** Whether a reference begins with these names. */
export const beginsWith = ({ names }: Reference, path: readonly string[]): boolean => path.every((name, i) => names[i] === name);
