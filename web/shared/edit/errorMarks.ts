// Where the errors of a document are in the model that is shown: at nodes and ports, which can be selected.
import type { ServerError } from "../../generated/messages";
import { selectionsOf } from "../model/identity";
import { ancestry, splitAddress, type ModelTree } from "../model/modelTree";
import { placeOf } from "./places";
import { elementOf, type Tree } from "./tree";

/** The innermost node or port that an element is a part of, as errors are about them. */
export interface ErrorSpot {
  readonly id: string;
  /** The state of the library that has it; nothing: the root has. */
  readonly top: string | undefined;
}

/** Of the document as a whole: its root. */
export function spotOf(tree: Tree, error: ServerError): ErrorSpot {
  const { id } = placeOf(tree, error);
  return spotOfElement(tree, id === "" ? tree.root : id);
}

export function spotOfElement(tree: Tree, id: string): ErrorSpot {
  const element = elementOf(tree, id);
  const shown = element.kind === "state" || element.kind === "barrier" || element.kind === "port" ? element : elementOf(tree, element.parent);
  let top = shown;
  while (top.parent !== "") top = elementOf(tree, top.parent);
  return { id: shown.id, top: top.id === tree.root ? undefined : top.id };
}

/** Numbers of errors by path of a node or address of a port. */
export interface ErrorMarks {
  /** Of a node: with its ports. */
  readonly own: ReadonlyMap<string, number>;
  /** Of a node: of all that is in it, without its own. */
  readonly inside: ReadonlyMap<string, number>;
}

export const noMarks: ErrorMarks = { own: new Map(), inside: new Map() };

/** The errors of the document `tree` in `model`, which is drawn of it or of what it became. */
export function errorMarks(tree: Tree, errors: readonly ServerError[], model: ModelTree): ErrorMarks {
  const [own, inside] = [new Map<string, number>(), new Map<string, number>()];
  const count = (counts: Map<string, number>, key: string) => counts.set(key, (counts.get(key) ?? 0) + 1);
  for (const error of errors) {
    const at = selectionsOf(model).get(spotOf(tree, error).id);
    if (at === undefined) continue;
    const path = at.kind === "node" ? at.path : (splitAddress(at.address)?.path ?? "");
    if (at.kind === "port") count(own, at.address);
    count(own, path);
    for (const above of ancestry(path).slice(0, -1)) count(inside, above);
  }
  return { own, inside };
}
