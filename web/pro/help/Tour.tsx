// The tour, in a corner of the page: what to do next, and what is done.
import { newestRun } from "../../shared/live/shownRun";
import { stepsDone, tourSteps } from "../../shared/help/tour";
import { useSession } from "../client";
import { openDocument, useEditing } from "../edit/editing";
import { CodeText } from "../panels/CodeText";
import { showHelp } from "./help";
import { endTour, useTour } from "./tour";

export function Tour() {
  const document = useTour();
  return document === undefined ? null : <Card document={document} />;
}

/** The document as it is edited, the number of its errors, and its newest run. */
function useFacts(document: string) {
  const tree = useEditing((now) => (now.document === document ? now.session?.view : undefined));
  const errors = useEditing((now) => (now.document === document ? (now.session?.errors.length ?? 0) : 0));
  const run = useSession((now) => newestRun(now.cores, document));
  return { tree, errors, run };
}

function Card({ document }: { readonly document: string }) {
  const facts = useFacts(document);
  const done = stepsDone(facts);
  const step = tourSteps[done];
  return (
    <aside className="tour" aria-label="Tour">
      <header>
        <h2>A first task</h2>
        <small>{step === undefined ? "done" : `${done + 1} of ${tourSteps.length}`}</small>
        <button type="button" aria-label="End the tour" onClick={endTour}>
          ✕
        </button>
      </header>
      <ol>
        {tourSteps.map(({ title }, i) => (
          <li key={title} className={i < done ? "is-done" : undefined} aria-current={i === done ? "step" : undefined}>
            {title}
            {i < done && <span className="unseen"> (done)</span>}
          </li>
        ))}
      </ol>
      <div role="status" className="tour-text">
        {facts.tree === undefined && facts.run === undefined ? (
          <button type="button" onClick={() => openDocument(document)}>
            Open {document} again
          </button>
        ) : step === undefined ? (
          <p>
            Your task has run. The Log below has what it printed; click a port in the drawing to see why it fired. Documents has larger tasks, and{" "}
            <button type="button" className="link" onClick={() => showHelp({ topic: "state" })}>
              the help
            </button>{" "}
            explains what they are made of.
          </p>
        ) : (
          <p>
            <CodeText text={step.text} />
          </p>
        )}
      </div>
    </aside>
  );
}
