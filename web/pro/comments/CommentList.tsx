// All open comments of the document, under the drawing: each leads to its thread. In the header of the document, how many there are.
import { commentsOf, isOpen, openComments, type Thread } from "../../shared/edit/comments/comments";
import { removeComment } from "../../shared/edit/comments/write";
import { elementText } from "../../shared/edit/difference/rows";
import type { Tree } from "../../shared/edit/tree";
import { useEditing } from "../edit/editing";
import { goToComments } from "./goToComments";
import { listComments, toggleComments, useCommentsListed } from "./listed";
import { carryOutNow } from "./perform";
import { counted } from "../../shared/counted";

/** More are not listed. */
const kMost = 200;

const openOf = (tree: Tree | undefined): readonly Thread[] => (tree === undefined ? [] : commentsOf(tree).threads.filter(isOpen));

export function CommentCount() {
  const count = useEditing(({ session }) => openOf(session?.view).length);
  const listed = useCommentsListed();
  if (count === 0) return null;
  return (
    <button type="button" className="comment-count" aria-expanded={listed} title={`${listed ? "Hide" : "List"} the open comments`} onClick={toggleComments}>
      {openComments(count)}
    </button>
  );
}

export function CommentList() {
  const tree = useEditing(({ session }) => session?.view);
  const listed = useCommentsListed();
  if (!listed || tree === undefined) return null;
  const threads = openOf(tree);
  return (
    <section className="usage-list comment-list" aria-label="Open comments">
      <header>
        <h3>Open comments {threads.length > kMost && <small>the first {kMost}</small>}</h3>
        <button type="button" className="usage-close" aria-label="Close the comments" onClick={() => listComments(false)}>
          ✕
        </button>
      </header>
      {threads.length === 0 && <p className="quiet pad">There are none. Ctrl+Alt+M comments on the state that is selected.</p>}
      <ul>
        {threads.slice(0, kMost).map((thread) => (
          <li key={thread.comment.id}>
            <Line tree={tree} thread={thread} />
          </li>
        ))}
      </ul>
    </section>
  );
}

function Line({ tree, thread: { comment, answers } }: { readonly tree: Tree; readonly thread: Thread }) {
  const said = (
    <span className="comment-line">
      <b>{comment.author}</b>: {comment.text}
      {answers.length > 0 && <small> {counted(answers.length, "answer")}</small>}
    </span>
  );
  if (tree.elements.has(comment.about))
    return (
      <button type="button" onClick={() => goToComments(comment.about, comment.id)}>
        <span>{elementText(tree, comment.about)}</span>
        {said}
      </button>
    );
  return (
    <div className="comment-gone">
      <span className="quiet">a state that is gone</span>
      {said}
      <button type="button" className="link" onClick={() => carryOutNow((now) => removeComment(now, comment.id))}>
        Delete
      </button>
    </div>
  );
}
