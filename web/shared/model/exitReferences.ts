// Exiting ports (thesis 3.1, Composition): a parent's port whose condition depends on a child's port.
import type { State } from "./model";

export interface ExitReference {
  readonly child: string;
  readonly port: string;
}

const kLiteral = /(["'])(?:\\.|(?!\1).)*\1/g;
const kReference = /\bchi\.([A-Za-z_]\w*)\.port\.([A-Za-z_]\w*)/g;

/** The child ports that a condition names as `chi.X.port.y`, each once, in order; text in literals does not count. */
export function exitReferences(condition: string): readonly ExitReference[] {
  const code = condition.replace(kLiteral, "''");
  const found = new Map<string, ExitReference>();
  for (const [, child, port] of code.matchAll(kReference)) {
    if (child !== undefined && port !== undefined) found.set(`${child}.${port}`, { child, port });
  }
  return [...found.values()];
}

/** The ports of `parent` whose conditions read this port of a child: it may end through them. */
export const exitsThrough = (parent: State | undefined, child: string, port: string): readonly string[] =>
  (parent?.ports ?? []).filter(({ when }) => when !== undefined && exitReferences(when).some((each) => each.child === child && each.port === port)).map(({ name }) => name);
