// Coverage of tests, at the elements of a document: what no test has come to, and how much there is.
import type { ConditionValue, ModelCoverage } from "../../generated/messages";
import { nameOfElement } from "../edit/commands/command";
import { elementOf, type Tree } from "../edit/tree";
import { kNeverAlone, neverText, partlyText, valueText } from "./texts";

export interface Count {
  readonly covered: number;
  readonly all: number;
}

export type GapKind = "states" | "ports" | "conditions";

/** What no test has come to. */
export interface Gap {
  readonly kind: GapKind;
  /** In the document: `Root/A`, `Root/A.done never true`. */
  readonly text: string;
  /** Of the state or port; nothing: the document has none. */
  readonly id: string | undefined;
}

/** Of a state or port: never active or fired; or, of a state that was, that not both values of its conditions were seen. */
export interface CoverageMark {
  readonly kind: "never" | "partly";
  readonly text: string;
}

export interface DocumentCoverage {
  readonly counts: Readonly<Record<GapKind, Count>>;
  readonly gaps: readonly Gap[];
  /** By id. */
  readonly marks: ReadonlyMap<string, CoverageMark>;
  /** States and ports of the coverage that the document does not have. */
  readonly unknown: readonly string[];
  /** States and ports of the document of which the coverage says nothing. */
  readonly untold: readonly string[];
}

/** The ids of states and ports, by their places as the server writes them: `Root/A`, `Root/A.done`, `library/Open`. */
export function placesOf(tree: Tree): ReadonlyMap<string, string> {
  const places = new Map<string, string>();
  const add = (place: string, id: string) => void (places.has(place) || places.set(place, id));
  const visit = (id: string, path: string) => {
    add(path, id);
    const { lists } = elementOf(tree, id);
    for (const port of lists.ports ?? []) add(`${path}.${nameOfElement(tree, port)}`, port);
    for (const child of lists.children ?? []) if (elementOf(tree, child).kind === "state") visit(child, `${path}/${nameOfElement(tree, child)}`);
  };
  visit(tree.root, nameOfElement(tree, tree.root));
  for (const id of tree.library) visit(id, `library/${nameOfElement(tree, id)}`);
  return places;
}

const countOf = ({ reached, missing }: { readonly reached: readonly unknown[]; readonly missing: readonly unknown[] }): Count => ({ covered: reached.length, all: reached.length + missing.length });

/** The state whose condition it is. */
const stateOf = ({ at, action }: ConditionValue): string => (action === undefined ? at.slice(0, at.lastIndexOf(".")) : at);

/** `Root/A.done never true`, `Root/A action 1 never false`. */
const conditionText = ({ at, action, value }: ConditionValue): string => `${at}${action === undefined ? "" : ` action ${action}`} ${valueText(value)}`;

/** The same within its state: `done never true`. */
const shortText = (condition: ConditionValue): string => conditionText({ ...condition, at: condition.action === undefined ? condition.at.slice(condition.at.lastIndexOf(".") + 1) : "" }).trim();

/** Conditions by the place of their state. */
function byState(conditions: readonly ConditionValue[]): ReadonlyMap<string, readonly ConditionValue[]> {
  const found = new Map<string, ConditionValue[]>();
  for (const each of conditions) {
    const before = found.get(stateOf(each));
    if (before === undefined) found.set(stateOf(each), [each]);
    else before.push(each);
  }
  return found;
}

/** A link to a state of the library is active in its place: the state itself, in tests of it alone. */
const isLibraryState = (place: string): boolean => /^library\/[^/.]+$/.test(place);

function marksOf({ states, ports, conditions }: ModelCoverage, places: ReadonlyMap<string, string>): ReadonlyMap<string, CoverageMark> {
  const marks = new Map<string, CoverageMark>();
  const mark = (place: string, made: CoverageMark) => {
    const id = places.get(place);
    if (id !== undefined && !marks.has(id)) marks.set(id, made);
  };
  for (const place of states.missing) mark(place, { kind: "never", text: isLibraryState(place) ? kNeverAlone : neverText("states") });
  for (const place of ports.missing) mark(place, { kind: "never", text: neverText("ports") });
  const reached = byState(conditions.reached);
  for (const [place, missing] of byState(conditions.missing)) {
    const count = { covered: reached.get(place)?.length ?? 0, all: (reached.get(place)?.length ?? 0) + missing.length };
    mark(place, { kind: "partly", text: partlyText(count, missing.map(shortText)) });
  }
  return marks;
}

/** Of a state of the library that cannot be run by itself, no test can be active in that itself. */
const isUncounted = (place: string, known: ReadonlySet<string>): boolean => {
  const [first, top] = place.split(/[/.]/);
  return first === "library" && !known.has(`library/${top ?? ""}`);
};

/** What a report says of a model, at the elements of a document, which may be of another revision or another one. */
export function coverageOf(tree: Tree, model: ModelCoverage): DocumentCoverage {
  const { states, ports, conditions } = model;
  const places = placesOf(tree);
  const known = new Set([states, ports].flatMap(({ reached, missing }) => [...reached, ...missing]));
  const gap = (kind: GapKind, place: string, text = place): Gap => ({ kind, text, id: places.get(place) });
  return {
    counts: { states: countOf(states), ports: countOf(ports), conditions: countOf(conditions) },
    gaps: [
      ...states.missing.map((place) => gap("states", place)),
      ...ports.missing.map((place) => gap("ports", place)),
      ...conditions.missing.map((each) => gap("conditions", each.at, conditionText(each))),
    ],
    marks: marksOf(model, places),
    unknown: [...known].filter((place) => !places.has(place)),
    untold: [...places.keys()].filter((place) => !known.has(place) && !isUncounted(place, known)),
  };
}
