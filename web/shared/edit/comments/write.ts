// Commands about comments. What is written is all text, so it may be sent as it was read.
import type { Operation } from "../apply";
import type { Command } from "../commands/command";
import { subtree, type Tree } from "../tree";
import { commentKey, commentsOf, resolvedKey, threadsOn, type Comment, type Thread } from "./comments";

/** Bounds of what is written here [characters, comments]. */
export const kMaxText = 2000;
export const kMaxOnElement = 100;
export const kMaxInDocument = 400;

/** Who writes, and when (ISO 8601). */
export interface By {
  readonly author: string;
  readonly time: string;
}

const set = (key: string, value?: Readonly<Record<string, string>>): Operation => ({ op: "set", id: "", field: "meta", key, ...(value !== undefined && { value }) });

const put = ({ id, ...fields }: Comment): Command => ({ change: { operations: [set(commentKey(id), fields)] } });

const kGone: Command = { reason: "the comment is not there any more" };

function reasonAgainstText(text: string): string | undefined {
  if (text.trim() === "") return "a comment needs a text";
  return Array.from(text).length > kMaxText ? `a comment has at most ${kMaxText} characters` : undefined;
}

const count = (threads: readonly Thread[]): number => threads.reduce((sum, { answers }) => sum + 1 + answers.length, 0);

function reasonAgainstOneMore(tree: Tree, about: string): string | undefined {
  if (commentsOf(tree).byId.size >= kMaxInDocument) return `a document has at most ${kMaxInDocument} comments; delete some`;
  return count(threadsOn(tree, about)) >= kMaxOnElement ? `there are ${kMaxOnElement} comments on it, and no more can be; delete some` : undefined;
}

/** A comment on a state or barrier. `id`: a new one. */
export function comment(tree: Tree, about: string, id: string, text: string, by: By): Command {
  const kind = tree.elements.get(about)?.kind;
  if (kind === undefined) return { reason: "what it is about is not there any more" };
  if (kind !== "state" && kind !== "barrier") return { reason: "comments are on states and barriers" };
  const reason = reasonAgainstText(text) ?? reasonAgainstOneMore(tree, about);
  return reason === undefined ? put({ id, about, ...by, text }) : { reason };
}

/** An answer in the thread that begins with `first`. */
export function answer(tree: Tree, first: string, id: string, text: string, by: By): Command {
  const to = commentsOf(tree).byId.get(first);
  if (to === undefined) return kGone;
  const reason = reasonAgainstText(text) ?? reasonAgainstOneMore(tree, to.about);
  return reason === undefined ? put({ id, about: to.about, answers: first, ...by, text }) : { reason };
}

/** Another text for one's own comment. */
export function rewrite(tree: Tree, id: string, text: string, { author, time }: By): Command {
  const before = commentsOf(tree).byId.get(id);
  if (before === undefined) return kGone;
  if (before.author !== author) return { reason: `only ${before.author} changes what ${before.author} has written` };
  const reason = text === before.text ? "the comment is as it was" : reasonAgainstText(text);
  return reason === undefined ? put({ ...before, text, edited: time }) : { reason };
}

const threadOf = (tree: Tree, first: string): Thread | undefined => commentsOf(tree).threads.find(({ comment: { id } }) => id === first);

export function resolve(tree: Tree, first: string, { author, time }: By): Command {
  const thread = threadOf(tree, first);
  if (thread === undefined) return kGone;
  return thread.resolved === undefined ? { change: { operations: [set(resolvedKey(first), { author, time })] } } : { reason: "it is resolved already" };
}

export function reopen(tree: Tree, first: string): Command {
  const thread = threadOf(tree, first);
  if (thread === undefined) return kGone;
  return thread.resolved === undefined ? { reason: "it is open already" } : { change: { operations: [set(resolvedKey(first))] } };
}

const without = ({ comment: { id }, answers, resolved }: Thread): readonly Operation[] => [
  ...[id, ...answers.map((each) => each.id)].map((each) => set(commentKey(each))),
  ...(resolved === undefined ? [] : [set(resolvedKey(id))]),
];

/** Deletes a comment; with the first one of a thread, the thread. */
export function removeComment(tree: Tree, id: string): Command {
  if (!commentsOf(tree).byId.has(id)) return kGone;
  const thread = threadOf(tree, id);
  return { change: { operations: thread === undefined ? [set(commentKey(id))] : without(thread) } };
}

/** What deletes the comments on these elements and on all that is in them. */
export function withoutCommentsOn(tree: Tree, ids: readonly string[]): readonly Operation[] {
  if (commentsOf(tree).threads.length === 0) return [];
  return ids.flatMap((id) => subtree(tree, id)).flatMap((id) => threadsOn(tree, id).flatMap(without));
}
