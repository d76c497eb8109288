// The tour: a first task, built and run by the person who reads it. What is done is read from the document and its run, so nothing has to be confirmed.
import type { Core } from "../../generated/messages";
import type { Tree } from "../edit/tree";
import { elementOf, type Element } from "../edit/tree";
import { isOver } from "../run/controls";

/** What the tour looks at. */
export interface TourFacts {
  /** The document of the tour is open, as it is edited; nothing: it is not. */
  readonly tree: Tree | undefined;
  /** Violations of it. */
  readonly errors: number;
  /** The newest run of it. */
  readonly run: Pick<Core, "status"> | undefined;
}

export interface TourStep {
  readonly title: string;
  /** What to do; code stands in backquotes. */
  readonly text: string;
  readonly done: (facts: TourFacts) => boolean;
}

const fieldOf = (element: Element, field: string): string => {
  const value = element.fields[field];
  return typeof value === "string" ? value : "";
};

const listed = (tree: Tree, { lists }: Element, list: "children" | "ports"): readonly Element[] => (lists[list] ?? []).map((id) => elementOf(tree, id));

const root = (tree: Tree): Element => elementOf(tree, tree.root);

/** Whether some state in the root is so. */
const someChild = (facts: TourFacts, is: (tree: Tree, child: Element) => boolean): boolean => {
  const { tree } = facts;
  return tree !== undefined && listed(tree, root(tree), "children").some((child) => child.kind === "state" && is(tree, child));
};

const hasPort = (tree: Tree, state: Element, is: (when: string) => boolean): boolean => listed(tree, state, "ports").some((port) => is(fieldOf(port, "when").trim()));

export const tourSteps: readonly TourStep[] = [
  {
    title: "Add a state",
    text: "Press `Insert`, or drag State from Add, on the left, onto the drawing. With `F2` it gets another name.",
    done: (facts) => someChild(facts, () => true),
  },
  {
    title: "Let it do something",
    text: "The state is selected. On the right, write `print(\"hello\")` into Entry, and press `Ctrl+Enter`: that is executed when the state is entered.",
    done: (facts) => someChild(facts, (_, child) => fieldOf(child, "entry").includes("print")),
  },
  {
    title: "Give it a way out",
    text: "Press `Alt+P` in the drawing, or + beside Ports on the right. Write `True` as its condition: the state is left at once.",
    done: (facts) => someChild(facts, (tree, child) => hasPort(tree, child, (when) => when === "True")),
  },
  {
    title: "Let the task end",
    text: "Select the state around it, and give it a port, too. Its condition names the port of the state inside: type `chi.`, and choose what is offered, such as `chi.State.port.success`.",
    done: (facts) => facts.tree !== undefined && facts.errors === 0 && hasPort(facts.tree, root(facts.tree), (when) => when.includes("chi.")),
  },
  { title: "Make a run", text: "Press `F5`. The run is made of the document as it is now, and shown; it does not start by itself.", done: ({ run }) => run !== undefined },
  { title: "Start it", text: "Press `F5` once more, or Start below.", done: ({ run }) => run !== undefined && isOver(run) },
];

/** How many steps are done: all before the first that is not. */
export function stepsDone(facts: TourFacts): number {
  const next = tourSteps.findIndex((step) => !step.done(facts));
  return next < 0 ? tourSteps.length : next;
}
