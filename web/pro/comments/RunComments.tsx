// The comments on the selected state of a run, as its document has them now: to be read; the page that edits the document is one click away.
import { isOpen, threadsOn, type Thread } from "../../shared/edit/comments/comments";
import { useCore, useSession } from "../client";
import { editing, openDocument } from "../edit/editing";
import { useDocument } from "./followedDocument";
import { focusComments, goToComments } from "./goToComments";
import { Said } from "./Said";

/** So long the page waits for the document [ms]. */
const kPatience = 10_000;

/** Opens the document, and goes to the comments on an element when it is there. */
function commentOn(document: string, element: string): void {
  openDocument(document);
  const isHere = () => editing.get().session?.view?.elements.has(element) === true;
  const go = () => {
    goToComments(element);
    focusComments(element);
  };
  if (isHere()) {
    go();
    return;
  }
  const end = editing.listen(() => {
    const isLeft = editing.get().document !== document;
    if (!isLeft && !isHere()) return;
    end();
    clearTimeout(timer);
    // The listeners after this one have the document, too, then.
    if (!isLeft) setTimeout(go);
  });
  const timer = setTimeout(end, kPatience);
}

export function RunComments({ id }: { readonly id: string | undefined }) {
  const name = useCore()?.document;
  // A run stays when its document is deleted.
  const document = useSession(({ documents }) => (documents.some((each) => each.name === name) ? name : undefined));
  const tree = useDocument(document);
  if (document === undefined || id === undefined || tree?.elements.has(id) !== true) return null;
  const threads = threadsOn(tree, id).filter(isOpen);
  return (
    <section className="comments" aria-label="Comments">
      <h3>Comments</h3>
      {threads.map((thread) => (
        <ReadThread key={thread.comment.id} thread={thread} />
      ))}
      <button type="button" className="link" onClick={() => commentOn(document, id)}>
        {threads.length === 0 ? "Comment in the editor" : "Answer in the editor"}
      </button>
    </section>
  );
}

function ReadThread({ thread: { comment, answers } }: { readonly thread: Thread }) {
  return (
    <article className="thread" aria-label={`Comment of ${comment.author}`}>
      {[comment, ...answers].map((each) => (
        <Said key={each.id} comment={each} />
      ))}
    </article>
  );
}
