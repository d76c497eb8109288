// The errors of the document that is edited: each leads to the element that it is about.
import type { ServerError } from "../../generated/messages";
import { placeText } from "../../shared/session/draft";
import { CodeText } from "../panels/CodeText";
import { useEditing } from "./editing";
import { explainCode } from "../help/help";
import { goToError } from "./errors";

const kNone: readonly ServerError[] = [];

export function ErrorList() {
  const errors = useEditing((now) => now.session?.errors ?? kNone);
  const readable = useEditing((now) => now.session?.confirmed !== undefined);
  if (errors.length === 0) return null;
  return (
    <section className="error-list" aria-label="Errors">
      <ul>
        {errors.map((error, i) => (
          <li key={i}>
            {readable ? (
              <button type="button" className="error-text" onClick={() => goToError(error)}>
                <ErrorText error={error} />
              </button>
            ) : (
              <div className="error-text">
                <ErrorText error={error} />
              </div>
            )}
            <button type="button" className="error-code" title={`What to do about ${error.code}`} onClick={() => explainCode(error.code)}>
              {error.code} ?
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}

function ErrorText({ error }: { readonly error: ServerError }) {
  return (
    <>
      <code>{placeText(error)}</code>
      <span>
        <CodeText text={error.message} />
      </span>
    </>
  );
}
