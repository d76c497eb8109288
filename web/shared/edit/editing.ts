// What the page knows of the document that is edited, as a value, and what an event makes of it.
import { assertNever } from "../assertNever";
import { isAt, type Conflict } from "./conflicts";
import { refusalText } from "./refusalText";
import type { EditSession, Notice } from "./session";

/** What is told above the drawing until its reader closes it: an edit that was refused, what cannot be done, or what somebody else did to what was
 *  written here (`met`); or, for a moment, what was done. */
export interface Told {
  readonly number: number;
  readonly text: string;
  readonly tone: "refused" | "met" | "done";
  /** The edit that was refused. */
  readonly notice?: Notice;
  /** The field that both have set. */
  readonly conflict?: Conflict;
}

export interface Editing {
  /** The name of the document; nothing: none is open. */
  readonly document: string | undefined;
  /** Nothing until the server has answered. */
  readonly session: EditSession | undefined;
  /** Id of the state that is shown as a whole: the root, or one of the library; nothing: the root. */
  readonly top: string | undefined;
  readonly told: readonly Told[];
}

export type EditingEvent =
  | { readonly type: "open"; readonly document: string | undefined }
  | { readonly type: "session"; readonly session: EditSession }
  | { readonly type: "top"; readonly id: string | undefined }
  | { readonly type: "notice"; readonly notice: Notice }
  | { readonly type: "met"; readonly text: string; readonly conflict: Conflict }
  | { readonly type: "said"; readonly text: string; readonly tone: Told["tone"] }
  | { readonly type: "seen"; readonly number: number };

export const nothingEdited: Editing = { document: undefined, session: undefined, top: undefined, told: [] };

/** Of refused edits that nobody has closed, the latest are kept. */
const kMostTold = 20;

/** What was said last is not said twice beneath itself; of a field, the last conflict is told. */
function tell(editing: Editing, said: Omit<Told, "number">): Editing {
  const last = editing.told.at(-1);
  const { conflict } = said;
  const before = last?.text === said.text ? editing.told.slice(0, -1) : editing.told;
  const others = conflict === undefined ? before : before.filter((each) => each.conflict === undefined || !isAt(each.conflict, conflict));
  return { ...editing, told: [...others, { number: (last?.number ?? 0) + 1, ...said }].slice(-kMostTold) };
}

export function applyEditing(editing: Editing, event: EditingEvent): Editing {
  switch (event.type) {
    case "open":
      return { ...nothingEdited, document: event.document };
    case "session":
      return { ...editing, session: event.session };
    case "top":
      return { ...editing, top: event.id };
    case "notice":
      return tell(editing, { text: refusalText(event.notice), tone: "refused", notice: event.notice });
    case "met":
      return tell(editing, { text: event.text, tone: "met", conflict: event.conflict });
    case "said":
      return tell(editing, { text: event.text, tone: event.tone });
    case "seen":
      return { ...editing, told: editing.told.filter(({ number }) => number !== event.number) };
    default:
      return assertNever(event);
  }
}

/** The state that is shown as a whole; nothing before the document is here. */
export function topOf({ session, top }: Editing): string | undefined {
  const tree = session?.view;
  if (tree === undefined) return undefined;
  return top !== undefined && tree.library.includes(top) ? top : tree.root;
}
