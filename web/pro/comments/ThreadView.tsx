// A thread of comments on an element of the document that is edited: what was said, and what can be done about it.
import { useState, type ReactNode } from "react";
import { isOpen, type Comment, type Thread } from "../../shared/edit/comments/comments";
import { commentField } from "../../shared/edit/comments/drafts";
import { answer, removeComment, reopen, resolve, rewrite } from "../../shared/edit/comments/write";
import { keyOfPlace } from "../../shared/edit/draftText";
import { useEditing } from "../edit/editing";
import { useDrafts } from "../edit/forms/drafts";
import { useRefusal } from "../login/rights";
import { useOwnName } from "../presence/ownName";
import { CommentField } from "./CommentField";
import { focusComments } from "./goToComments";
import { NewComments } from "./NewComments";
import { carryOutNow } from "./perform";
import { Said } from "./Said";

export function ThreadView({ thread }: { readonly thread: Thread }) {
  const { comment, answers } = thread;
  const isAnswerable = isOpen(thread);
  const refusal = useRefusal("edit");
  const leave = (make: Parameters<typeof carryOutNow>[0]) => carryOutNow(make) && focusComments(comment.about);
  return (
    <article className="thread" aria-label={`Comment of ${comment.author}`} data-thread={comment.id} tabIndex={-1}>
      <OneComment comment={comment}>
        {isAnswerable ? (
          <button type="button" disabled={refusal !== undefined} title={refusal} onClick={() => leave((tree, by) => resolve(tree, comment.id, by))}>
            Resolve
          </button>
        ) : (
          <button type="button" disabled={refusal !== undefined} title={refusal} onClick={() => leave((tree) => reopen(tree, comment.id))}>
            Reopen
          </button>
        )}
      </OneComment>
      {answers.map((each) => (
        <OneComment key={each.id} comment={each} />
      ))}
      {isAnswerable ? (
        <NewComments about={comment.about} first={comment.id} label={`Answer to ${comment.author}`} placeholder="Answer…" send="Answer" make={(id, text, tree, by) => answer(tree, comment.id, id, text, by)} />
      ) : (
        <small className="quiet">Resolved{thread.resolved?.author === undefined || thread.resolved.author === "" ? "" : ` by ${thread.resolved.author}`}</small>
      )}
    </article>
  );
}

interface OneProps {
  readonly comment: Comment;
  readonly children?: ReactNode;
}

function OneComment({ comment, children }: OneProps) {
  const { id, about, author, text } = comment;
  const document = useEditing((now) => now.document) ?? "";
  const field = commentField(id);
  const hasDraft = useDrafts((drafts) => drafts.has(keyOfPlace({ document, id: about, field })));
  const [isOpened, open] = useState(false);
  const isOwn = useOwnName().name === author;
  const refusal = useRefusal("edit");
  return (
    <Said comment={comment} hidesText={isOpened || hasDraft}>
      {(isOpened || hasDraft) && (
        <CommentField id={about} field={field} label="Your comment" send="Save" now={text} make={(next, tree, by) => rewrite(tree, id, next, by)} autoFocus={isOpened} onEnd={() => open(false)} />
      )}
      <span className="thread-tools">
        {children}
        {isOwn && !isOpened && !hasDraft && (
          <button type="button" disabled={refusal !== undefined} title={refusal} onClick={() => open(true)}>
            Edit
          </button>
        )}
        <button type="button" disabled={refusal !== undefined} title={refusal} onClick={() => carryOutNow((tree) => removeComment(tree, id)) && focusComments(about)}>
          Delete
        </button>
      </span>
    </Said>
  );
}
