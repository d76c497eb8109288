// Names in a text of code that mean nothing in its scope. Found while it is typed; the server finds these and all other errors when the text
// has been sent.
import { callAround, localNames } from "./find";
import type { Name } from "./names";
import { referencesIn, type Reference } from "./references";
import type { Scope } from "./scope";
import { fieldsOf } from "./strings";
import { tokensOf, type Span, type Token } from "./tokens";
import { isCollection } from "./words";

export interface Mistake extends Span {
  readonly message: string;
  /** A warning: the server takes it, as a service may come later. */
  readonly severity: "error" | "warning";
}

/** The first name of a path that what stands before it does not have. */
function unknownIn({ names, spans }: Reference, scope: Scope): Mistake | undefined {
  const [root = "", ...rest] = names;
  let at = scope.names.find(({ name }) => name === root);
  if (at === undefined) return { ...(spans[0] ?? { from: 0, to: 0 }), severity: "error", message: `${root} is not visible in an expression` };
  for (const [i, name] of rest.entries()) {
    const found: Name | undefined = at.members?.().find((each) => each.name === name);
    if (found === undefined && at.isOpen === true) return undefined;
    if (found === undefined) return { ...(spans[i + 1] ?? { from: 0, to: 0 }), severity: root === "svc" ? "warning" : "error", message: unknownText(names.slice(0, i + 1), name) };
    at = found;
  }
  return undefined;
}

function unknownText(path: readonly string[], name: string): string {
  const isRoot = path.length === 1;
  if (isRoot && path[0] === "chi") return `there is no child ${name}`;
  if (isRoot && path[0] === "svc") return `there is no service ${name} now`;
  return isRoot || (path[0] === "chi" && path.length === 3) ? `${name} is not declared here` : `${path.join(".")} has no ${name}`;
}

const is = (token: Token | undefined, text: string): boolean => token?.kind === "operator" && token.text === text;

/** Plain names that are no functions and get no value, and functions that a module does not have. */
function unknownNames(text: string, tokens: readonly Token[], scope: Scope, locals: ReadonlySet<string>): readonly Mistake[] {
  return tokens.flatMap((token, at): readonly Mistake[] => {
    if (token.kind === "string") return fieldsOf(text, token).flatMap(({ from, to }) => unknownNames(text, tokensOf(text, from, to), scope, locals));
    if (token.kind !== "name" || is(tokens[at - 1], ".") || isCollection(token.text) || locals.has(token.text)) return [];
    if (is(tokens[at + 1], "=") && callAround(tokens, at) !== undefined) return [];
    const known = scope.names.find(({ name }) => name === token.text);
    if (known === undefined) return [{ from: token.from, to: token.to, severity: "error", message: `${token.text} is not known here` }];
    const member = is(tokens[at + 1], ".") ? tokens[at + 2] : undefined;
    if (known.kind !== "module" || member?.kind !== "name" || known.members?.().some(({ name }) => name === member.text)) return [];
    return [{ from: member.from, to: member.to, severity: "error", message: `${token.text} has no ${member.text}` }];
  });
}

/** In the order of the text. */
export function mistakesIn(text: string, scope: Scope): readonly Mistake[] {
  const paths = referencesIn(text).map((reference) => unknownIn(reference, scope)).filter((mistake) => mistake !== undefined);
  const names = unknownNames(text, tokensOf(text), scope, new Set(localNames(text)));
  return [...paths, ...names].sort((a, b) => a.from - b.from);
}
