// Dynamic oracles (thesis 3.3.2) in a translated model: the state in front of a composite's children that was not written by
// the author is its dispatcher, which implements the oracle.
import type { Dispatcher, Node, State } from "./model";

/** Path in the native model -> path in the document that it was translated from (api/schemas: native). */
export type Origin = Readonly<Record<string, string>>;

/** The variable in which a history has its last child. */
const kMemory = "last_active";

const choiceOf = (dispatcher: State) => dispatcher.parameters.find(({ name }) => name === "choice")?.from;

function kindOf(dispatcher: State, { keepsDeep }: State): Dispatcher {
  if (choiceOf(dispatcher) !== `var.${kMemory}`) return "choice";
  return keepsDeep === true ? "deep history" : "history";
}

/** The variable and the actions by which a history remembers its last child, marked. */
function markMemory({ variables, actions, children }: State): Pick<State, "variables" | "actions"> {
  const stores = new Set(children.map(({ name }) => `var.${kMemory} = '${name}'`));
  return {
    variables: variables.map((variable) => (variable.name === kMemory ? { ...variable, made: true } : variable)),
    actions: actions.map((action) => (stores.has(action.do) ? { ...action, made: true } : action)),
  };
}

/** The model with its dispatchers and what histories remember marked, and the oracles in the states that have one. */
export function withOracles(root: State, origin: Origin): State {
  const mark = (state: State, path: string): State => {
    const first = state.children.find((child) => child.name === state.first);
    // It comes from where its siblings' parent was written, which is the library if the state is a link.
    const home = first === undefined ? undefined : origin[`${path}/${first.name}`];
    const translated = first?.kind === "state" && state.children.some(({ name }) => origin[`${path}/${name}`] === `${home ?? ""}/${name}`);
    const children = state.children.map((child): Node => {
      if (child.kind === "barrier") return child;
      return mark(translated && child === first ? { ...child, dispatcher: kindOf(child, state) } : child, `${path}/${child.name}`);
    });
    if (!translated) return { ...state, children };
    const kind = kindOf(first, state);
    if (kind === "choice") return { ...state, children, oracle: choiceOf(first) ?? first.entry ?? "external" };
    return { ...state, ...markMemory(state), children, oracle: kind };
  };
  return mark(root, root.name);
}
