// The comments of a document, read from its `meta` as threads.
import { entryOf, isObject, type JsonObject, type JsonValue } from "../../json";
import type { Tree } from "../tree";
import { counted } from "../../counted";

export interface Comment {
  readonly id: string;
  /** The id of the element that it is about. */
  readonly about: string;
  /** A name. */
  readonly author: string;
  /** ISO 8601. */
  readonly time: string;
  readonly text: string;
  /** When its author has changed it last. */
  readonly edited?: string;
  /** The first comment of its thread, if it is another one. */
  readonly answers?: string;
}

export interface Thread {
  /** The first comment. */
  readonly comment: Comment;
  /** Those that came first, first. */
  readonly answers: readonly Comment[];
  readonly resolved: { readonly author: string; readonly time: string } | undefined;
}

export interface Comments {
  readonly byId: ReadonlyMap<string, Comment>;
  /** In the order in which they were begun. */
  readonly threads: readonly Thread[];
  /** The same, by the id of the element. */
  readonly byElement: ReadonlyMap<string, readonly Thread[]>;
}

const [kComment, kResolved] = ["comment:", "resolved:"];

/** The keys of their entries in the `meta` of the document. */
export const commentKey = (id: string): string => `${kComment}${id}`;
export const resolvedKey = (id: string): string => `${kResolved}${id}`;

/** Whether an entry of the `meta` of a document is one of comments. */
export const isOfComments = (key: string): boolean => key.startsWith(kComment) || key.startsWith(kResolved);

const kNone: Comments = { byId: new Map(), threads: [], byElement: new Map() };
const known = new WeakMap<JsonObject, Comments>();

const textIn = (fields: JsonObject, field: string): string | undefined => {
  const value = entryOf(fields, field);
  return typeof value === "string" ? value : undefined;
};

function commentOf(id: string, value: JsonValue): Comment | undefined {
  if (!isObject(value)) return undefined;
  const [about, author, time, text] = ["about", "author", "time", "text"].map((field) => textIn(value, field));
  if (about === undefined || author === undefined || time === undefined || text === undefined) return undefined;
  const [edited, answers] = [textIn(value, "edited"), textIn(value, "answers")];
  return { id, about, author, time, text, ...(edited !== undefined && { edited }), ...(answers !== undefined && { answers }) };
}

function resolvedIn(meta: JsonObject, id: string): Thread["resolved"] {
  const value = entryOf(meta, resolvedKey(id));
  if (!isObject(value)) return undefined;
  return { author: textIn(value, "author") ?? "", time: textIn(value, "time") ?? "" };
}

const inOrder = (a: Comment, b: Comment): number => (a.time === b.time ? (a.id < b.id ? -1 : 1) : a.time < b.time ? -1 : 1);

function groupedBy<T>(items: readonly T[], keyOf: (item: T) => string): ReadonlyMap<string, readonly T[]> {
  const groups = new Map<string, T[]>();
  for (const item of items) {
    const group = groups.get(keyOf(item));
    if (group === undefined) groups.set(keyOf(item), [item]);
    else group.push(item);
  }
  return groups;
}

function read(meta: JsonObject): Comments {
  const all = Object.entries(meta)
    .flatMap(([key, value]) => (key.startsWith(kComment) ? [commentOf(key.slice(kComment.length), value)] : []))
    .filter((comment) => comment !== undefined)
    .sort(inOrder);
  if (all.length === 0) return kNone;
  const byId = new Map(all.map((comment) => [comment.id, comment]));
  /** The first comment of the thread; an answer to one that is gone, or to an answer, begins one itself. */
  const first = (comment: Comment): string => {
    const to = byId.get(comment.answers ?? "");
    return to === undefined || to.answers !== undefined ? comment.id : to.id;
  };
  const groups = groupedBy(all, first);
  const threads = all.flatMap((comment): Thread[] => {
    if (first(comment) !== comment.id) return [];
    const answers = (groups.get(comment.id) ?? []).filter((each) => each !== comment);
    return [{ comment, answers, resolved: resolvedIn(meta, comment.id) }];
  });
  return { byId, threads, byElement: groupedBy(threads, ({ comment: { about } }) => about) };
}

/** The same object as long as the `meta` of the document is the same. */
export function commentsOf({ fields }: Tree): Comments {
  const meta = entryOf(fields, "meta");
  if (!isObject(meta)) return kNone;
  const before = known.get(meta);
  if (before !== undefined) return before;
  const found = read(meta);
  known.set(meta, found);
  return found;
}

const kNoThreads: readonly Thread[] = [];

export const threadsOn = (tree: Tree, element: string): readonly Thread[] => commentsOf(tree).byElement.get(element) ?? kNoThreads;

export const isOpen = ({ resolved }: Thread): boolean => resolved === undefined;

export const openComments = (count: number): string => counted(count, "open comment");
