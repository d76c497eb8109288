// What may be written at a position of a text of code.
import { methodsOf } from "./methods";
import { typeText, type Name } from "./names";
import { callAround, localNames, meaningOf, tokensAround, wordsBefore } from "./find";
import type { Scope } from "./scope";
import { kExpressionKeywords, kStatementKeywords } from "./words";

export interface CompletionItem {
  readonly name: Name;
  /** In place of what is there from `Completion.from` on. */
  readonly insert: string;
  /** Where the cursor stands in `insert` then. */
  readonly cursor: number;
  /** Beside the name: parameters, type and unit. */
  readonly detail: string;
  /** Of an operation: why no service can accept it there. */
  readonly against?: string;
}

export interface Completion {
  readonly from: number;
  /** A name has been begun, or a dot stands before it: it is useful to show the items without being asked. */
  readonly isBegun: boolean;
  /** What stands before the dot, as `svc.gripper`; empty: there is none. */
  readonly of: string;
  readonly items: readonly CompletionItem[];
}

/** `(pose, [speed])`, `number [m]`, or what kind of name it is. */
export function detailOf({ call, kind, type, unit }: Name): string {
  if (call !== undefined) return `(${call})`;
  const of = type === undefined ? kind : typeText(type);
  return unit === undefined ? of : `${of} [${unit}]`;
}

/** An operation is called by a function; a condition reads what it has answered. */
function isCalled({ kind }: Name, scope: Scope): boolean {
  return kind === "function" || kind === "method" || (kind === "operation" && scope.kind === "function");
}

function itemOf(name: Name, scope: Scope, next: string): CompletionItem {
  const insert = name.kind === "argument" ? `${name.name}=` : isCalled(name, scope) && next !== "(" ? `${name.name}()` : name.name;
  const isInside = insert.endsWith("()") && name.call !== "";
  return { name, insert, cursor: insert.length - (isInside ? 1 : 0), detail: name.kind === "keyword" ? "" : detailOf(name) };
}

const keywords = ({ kind }: Scope): readonly Name[] => [...kExpressionKeywords, ...(kind === "function" ? kStatementKeywords : [])].map((name) => ({ name, kind: "keyword" }));

/** Nothing: nothing can be said there, as in a comment. */
export function completionAt(text: string, position: number, scope: Scope): Completion | undefined {
  const tokens = tokensAround(text, position);
  if (tokens === undefined) return undefined;
  const under = tokens.findIndex(({ kind, from, to }) => (kind === "name" || kind === "keyword") && from < position && position <= to);
  const word = tokens[under];
  const behind = tokens.findIndex(({ from }) => from >= position);
  const at = word === undefined ? (behind < 0 ? tokens.length : behind) : under;
  const path = wordsBefore(tokens, at);
  if (path === undefined || tokens[at - 1]?.kind === "number") return undefined;
  const from = word?.from ?? position;
  const next = text[word?.to ?? position] ?? "";
  const items = (names: readonly Name[]) => names.map((name) => itemOf(name, scope, next));
  if (path.length > 0) {
    const meaning = meaningOf(scope, path.map(({ text: name }) => name));
    const members = [...(meaning?.members?.() ?? []), ...(meaning?.kind === "operation" ? [] : methodsOf(meaning?.type))];
    return members.length === 0 ? undefined : { from, isBegun: true, of: path.map(({ text: name }) => name).join("."), items: items(members) };
  }
  const call = callAround(tokens, at);
  const called = call && meaningOf(scope, call);
  const locals = localNames(text).filter((name) => name !== word?.text).map((name): Name => ({ name, kind: "local" }));
  return { from, isBegun: word !== undefined, of: "", items: items([...(called?.parameters ?? []), ...locals, ...scope.names, ...keywords(scope)]) };
}

/** Whether it offers operations of a service. */
export const offersOperations = ({ items }: Completion): boolean => items.some(({ name }) => name.kind === "operation");

/** Marks operations that no service can accept there, by `svc.key.operation` with the reason; they stand last. */
export function marked(completion: Completion, unreachable: ReadonlyMap<string, string>): Completion {
  const items = completion.items.map((item): CompletionItem => {
    const against = unreachable.get(`${completion.of}.${item.name.name}`);
    return against === undefined ? item : { ...item, against };
  });
  return { ...completion, items: [...items.filter(({ against }) => against === undefined), ...items.filter(({ against }) => against !== undefined)] };
}
