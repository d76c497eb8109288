// What is not saved of an application: edits that the server has not taken yet, and those that it has refused.
import { withNames } from "../shared/edit/changeText";
import { plain } from "../shared/edit/exact";
import { reasonText } from "../shared/edit/refusalText";
import type { Change, Notice } from "../shared/edit/session";
import type { Tree } from "../shared/edit/tree";
import { entryOf, isObject, type JsonValue } from "../shared/json";
import { skillOf } from "../shared/skills/skill";
import { texts } from "./texts";

const t = texts.leave;

/** An edit that is not in the application and will not be, for people. */
export interface RefusedEdit {
  /** The step that it was about, or what was to be done. */
  readonly what: string;
  readonly why: string;
}

/** The nearest state that is or has an element: its title. */
function titleAt(tree: Tree, id: string): string | undefined {
  const element = tree.elements.get(id);
  if (element === undefined) return undefined;
  return element.kind === "state" ? skillOf(tree, id).title : titleAt(tree, element.parent);
}

/** Of a node that is written. */
function idOf(node: JsonValue): string {
  const meta = isObject(node) ? entryOf(node, "meta") : undefined;
  const id = isObject(meta) ? entryOf(meta, "id") : undefined;
  return typeof id === "string" ? id : "";
}

function subjectOf(tree: Tree | undefined, change: Change): string {
  if ("undo" in change) return texts.frame.undo;
  if ("redo" in change) return texts.frame.redo;
  if (tree === undefined || !("operations" in change)) return t.aChange;
  const ids = change.operations.flatMap((operation) => (operation.op === "insert" ? [idOf(plain<JsonValue>(operation.node)), operation.parent] : [operation.id]));
  const title = ids.map((id) => titleAt(tree, id)).find((found) => found !== undefined);
  return title === undefined ? t.aChange : t.about(title);
}

/** `tree`: the application as it was shown last. */
export const refusedEdit = (tree: Tree | undefined, notice: Notice): RefusedEdit => ({ what: subjectOf(tree, notice.change), why: tree === undefined ? reasonText(notice) : withNames(tree, reasonText(notice)) });

export interface Unsaved {
  /** How many edits wait for the server. */
  readonly waiting: number;
  readonly refused: readonly RefusedEdit[];
}

export interface Question {
  readonly title: string;
  readonly means: readonly string[];
  /** What leaves. */
  readonly leave: string;
  /** Something is lost by leaving. */
  readonly loses: boolean;
}

/** What a person is asked who leaves the application. */
export function questionOf({ waiting, refused }: Unsaved): Question {
  const count = refused.length;
  if (waiting > 0) return { title: t.title(waiting + count), means: [t.lost(count), ...(count > 0 ? [t.refused(count)] : [])], leave: t.giveUp, loses: true };
  if (count > 0) return { title: t.refusedTitle(count), means: [t.othersSaved, t.refused(count)], leave: t.leaveWithout(count), loses: false };
  return { title: t.savedTitle, means: [t.saved], leave: t.leave, loses: false };
}
