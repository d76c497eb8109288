// The calls of operations in the code of a state, and what its conditions say about responses and about ports of children.
// Texts are read loosely, in the safe direction: a call in a comment counts as a call, and a condition that is not plain says nothing.
import type { State } from "../model/model";

/** A call `svc.service.operation(...)`; without `service`: that is computed, so it may be any. */
export interface Call {
  readonly service: string | undefined;
  readonly operation: string;
}

const kCall = /\bsvc\s*(?:\.\s*(\w+)|\[)\s*(?:\.\s*(\w+)\s*\()?/g;
const kMethod = /\.\s*(\w+)\s*\(/g;

/** All calls, in the order of the text. */
export function callsIn(code: string): readonly Call[] {
  return [...code.matchAll(kCall)].flatMap(({ 0: text, 1: service, 2: operation, index }): readonly Call[] => {
    if (service !== undefined) return operation === undefined ? [] : [{ service, operation }];
    // `svc[expr].operation(...)`: any name that is called from here on.
    return [...code.slice(index + text.length).matchAll(kMethod)].map(([, name = ""]) => ({ service: undefined, operation: name }));
  });
}

const textsOf = ({ entry, exit, oracle, actions }: State): readonly string[] => [entry, exit, oracle, ...actions.map((action) => action.do)].filter((text) => text !== undefined);

/** Asked for with each change of a run; a state is never changed, another takes its place. */
const kKnown = new WeakMap<State, readonly Call[]>();

/** All calls of a state and of what is within it. */
export function callsOf(state: State): readonly Call[] {
  const known = kKnown.get(state);
  if (known !== undefined) return known;
  const calls = [...textsOf(state).flatMap(callsIn), ...state.children.flatMap((child) => (child.kind === "state" ? callsOf(child) : []))];
  kKnown.set(state, calls);
  return calls;
}

/** Whether the order of the calls in the code may differ from that in its text. */
export const repeats = (code: string): boolean => /\b(for|while)\b/.test(code);

/** What holds when a condition is fulfilled: that an operation has been answered with a result, or that a child was left through a port. */
export type Fact =
  | { readonly type: "answered"; readonly service: string; readonly operation: string }
  | { readonly type: "left"; readonly child: string; readonly port: string };

const kLiteral = /(["'])(?:\\.|(?!\1).)*\1/g;
const kAvailable = /\bavailable\(\s*(svc\.\w+\.\w+\.result)\b[\w.]*\s*\)/g;
const kNotPlain = /\b(or|if|for)\b|[()[\]{}#'"]/;
const kAnswered = /^svc\.(\w+)\.(\w+)\.result\b/;
const kLeft = /^chi\.(\w+)\.port\.(\w+)$/;

/** The facts among the parts of a condition that are joined by `and`. */
export function factsOf(condition: string): readonly Fact[] {
  const plain = condition.replace(kLiteral, "0").replace(kAvailable, "$1");
  if (kNotPlain.test(plain)) return [];
  return plain.split(/\band\b/).flatMap((part): readonly Fact[] => {
    const [, service, operation] = kAnswered.exec(part.trim()) ?? [];
    if (service !== undefined && operation !== undefined) return [{ type: "answered", service, operation }];
    const [, child, port] = kLeft.exec(part.trim()) ?? [];
    return child !== undefined && port !== undefined ? [{ type: "left", child, port }] : [];
  });
}
