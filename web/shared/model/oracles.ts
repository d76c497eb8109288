// Dynamic oracles (thesis 3.3.2) in a translated model: the state in front of a composite's children that was not written by
// the author is its dispatcher, which implements the oracle.
import type { Node, State } from "./model";

/** Path in the native model -> path in the document that it was translated from (api/schemas: native). */
export type Origin = Readonly<Record<string, string>>;

/** `history`, or the expression or call that chooses the first child. */
function oracleOf(dispatcher: State): string {
  const choice = dispatcher.parameters.find(({ name }) => name === "choice")?.from;
  return choice === "var.last_active" ? "history" : (choice ?? dispatcher.entry ?? "external");
}

/** The model with its dispatchers marked, and the oracles in the states that have one. */
export function withOracles(root: State, origin: Origin): State {
  const mark = (state: State, path: string): State => {
    const first = state.children.find((child) => child.name === state.first);
    // It comes from where its siblings' parent was written, which is the library if the state is a link.
    const home = first === undefined ? undefined : origin[`${path}/${first.name}`];
    const translated = first?.kind === "state" && state.children.some(({ name }) => origin[`${path}/${name}`] === `${home ?? ""}/${name}`);
    const children = state.children.map((child): Node => {
      if (child.kind === "barrier") return child;
      return mark(translated && child === first ? { ...child, dispatcher: true } : child, `${path}/${child.name}`);
    });
    return translated ? { ...state, children, oracle: oracleOf(first) } : { ...state, children };
  };
  return mark(root, root.name);
}
