// Where a new comment, or an answer, is written: what is written and not sent yet, else an empty field.
import { useMemo, useState } from "react";
import type { Command } from "../../shared/edit/commands/command";
import { commentsOf } from "../../shared/edit/comments/comments";
import { answerField, commentField, newOnes } from "../../shared/edit/comments/drafts";
import type { By } from "../../shared/edit/comments/write";
import type { Tree } from "../../shared/edit/tree";
import { useEditing } from "../edit/editing";
import { useDrafts } from "../edit/forms/drafts";
import { CommentField } from "./CommentField";
import { newCommentId } from "./perform";

interface Props {
  readonly about: string;
  /** The first comment of the thread that is answered; nothing: a new thread. */
  readonly first?: string;
  readonly label: string;
  readonly placeholder: string;
  readonly send: string;
  readonly make: (id: string, text: string, tree: Tree, by: By) => Command;
}

export function NewComments({ about, first, label, placeholder, send, make }: Props) {
  const document = useEditing((now) => now.document) ?? "";
  const tree = useEditing((now) => now.session?.view);
  const drafts = useDrafts((all) => all);
  const [fresh, renew] = useState(newCommentId);
  const written = useMemo(
    () => newOnes(drafts, { document, id: about }, first, (id) => tree !== undefined && commentsOf(tree).byId.has(id)),
    [drafts, document, about, first, tree],
  );
  if (tree !== undefined && commentsOf(tree).byId.has(fresh)) renew(newCommentId());
  const ids = written.includes(fresh) || written.length === 0 ? [...written.filter((id) => id !== fresh), fresh] : written;
  // The field keeps the focus when its comment is sent and the next one begins.
  return ids.map((id) => (
    <CommentField key={id === fresh ? "fresh" : id} id={about} field={first === undefined ? commentField(id) : answerField(first, id)} label={label} placeholder={placeholder} send={send} now="" make={(text, now, by) => make(id, text, now, by)} />
  ));
}
