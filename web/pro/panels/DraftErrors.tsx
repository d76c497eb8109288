// The errors of a draft, in the place of a drawing: a document with errors has no model.
import { countErrors, errorsText } from "../../shared/run/errorsText";
import { placeText } from "../../shared/session/draft";
import { useSession, view } from "../client";
import { CodeText } from "./CodeText";

export function DraftErrors() {
  const draft = useSession((s) => s.draft);
  if (draft === undefined) return null;
  const { name, revision, errors, more_errors } = draft;
  const faultless = errors.length === 0;
  return (
    <section className="draft" aria-label={`Errors of ${name}`}>
      <header>
        <small>
          {faultless ? "Document" : "Draft"} · revision {revision}
        </small>
        <h2>{name}</h2>
        <p>{faultless ? "It has no errors any more and can be started." : `It has ${errorsText(countErrors(errors, more_errors))} and cannot be started.`}</p>
        <button type="button" className="draft-close" onClick={() => view.dispatch({ type: "page", page: "task" })}>
          Close
        </button>
      </header>
      <ul>
        {errors.map((error, i) => (
          <li key={i}>
            <code>{placeText(error)}</code>
            <p>
              <CodeText text={error.message} />
            </p>
            <small>{error.code}</small>
          </li>
        ))}
      </ul>
      {more_errors && <p className="quiet">There are more errors, which are not listed.</p>}
    </section>
  );
}
