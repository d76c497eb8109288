// The comments on the selected element, in its form: open threads, those that are resolved folded away, and a field for a new one.
import { comment, type By } from "../../shared/edit/comments/write";
import { isOpen, threadsOn, type Thread } from "../../shared/edit/comments/comments";
import type { Tree } from "../../shared/edit/tree";
import { useEditing } from "../edit/editing";
import { NewComments } from "./NewComments";
import { ThreadView } from "./ThreadView";

const kNone: readonly Thread[] = [];

export function CommentSection({ id }: { readonly id: string }) {
  const threads = useEditing(({ session }) => (session?.view === undefined ? kNone : threadsOn(session.view, id)));
  const open = threads.filter(isOpen);
  const resolved = threads.filter((thread) => !isOpen(thread));
  return (
    <section className="form-section comments" aria-label="Comments" data-comments={id}>
      <h3>Comments</h3>
      {open.map((thread) => (
        <ThreadView key={thread.comment.id} thread={thread} />
      ))}
      {resolved.length > 0 && (
        <details className="comments-resolved">
          <summary>{resolved.length} resolved</summary>
          {resolved.map((thread) => (
            <ThreadView key={thread.comment.id} thread={thread} />
          ))}
        </details>
      )}
      <NewComments about={id} label="New comment" placeholder="Ask or remark something…" send="Comment" make={(own, text, tree: Tree, by: By) => comment(tree, id, own, text, by)} />
    </section>
  );
}
