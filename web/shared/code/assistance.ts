// Assistance in orchestration for a text of a document: where it stands, as the analysis has it (../orchestration/unreachable.ts).
import { elementOf, type Tree } from "../edit/tree";
import { editedModel } from "../edit/editedModel";
import type { KnownService as RsmOfService } from "../orchestration/automata";
import type { CodePlace as AnalysedPlace } from "../orchestration/unreachable";
import { keyOf, type RcmDocument, type State } from "../model/model";
import type { CodePlace } from "./scope";
import { knownServices, type KnownService } from "./services";

/** What is analysed: the same object as long as neither states nor services change. */
export interface Task {
  readonly document: RcmDocument;
  readonly services: readonly RsmOfService[];
}

const same = <T>(a: readonly T[], b: readonly T[], isSame = (one: T, other: T | undefined) => one === other): boolean => a.length === b.length && a.every((item, i) => isSame(item, b[i]));

/** `before`: the task of an earlier tree. */
export function taskOf(tree: Tree, services: readonly KnownService[], before: Task | undefined): Task {
  const document = editedModel(tree);
  const found = knownServices(tree, services).map(({ key, rsm }) => ({ key, rsm }));
  const isKnown =
    before !== undefined && before.document.root === document.root && same(before.document.library, document.library) && same(before.services, found, (one, other) => one.key === other?.key && one.rsm === other.rsm);
  return isKnown ? before : { document, services: found };
}

/** Where in the task: the path of the state, and which of its code. */
export interface Spot {
  readonly path: string;
  readonly place: AnalysedPlace;
}

/** Keys from the outermost state to the one with this id. */
function keysTo(tree: Tree, top: State, id: string): readonly string[] | undefined {
  const ids: string[] = [];
  for (let at = id; at !== ""; at = elementOf(tree, at).parent) ids.unshift(at);
  const keys: string[] = [];
  let found: State | undefined;
  for (const each of ids) {
    found = found === undefined ? top : found.children.find((child): child is State => child.kind === "state" && child.id === each);
    if (found?.id !== each) return undefined;
    keys.push(keyOf(found));
  }
  return keys;
}

/** `before`: the text in front of what is inserted. Nothing: no operations are called in this field. */
export function spotOf(tree: Tree, { document: { root, library } }: Task, { id, field }: CodePlace, before: string): Spot | undefined {
  if (field !== "entry" && field !== "exit" && field !== "do") return undefined;
  const state = field === "do" ? elementOf(tree, id).parent : id;
  const [path] = [root, ...library].flatMap((top) => keysTo(tree, top, state)?.join("/") ?? []);
  return path === undefined ? undefined : { path, place: field === "do" ? { code: "action" } : { code: field, before } };
}
