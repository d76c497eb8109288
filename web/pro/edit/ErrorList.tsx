// The errors of the document that is edited: each leads to the element that it is about.
import type { ServerError } from "../../generated/messages";
import { placeText } from "../../shared/session/draft";
import { CodeText } from "../panels/CodeText";
import { useEditing } from "./editing";
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
              <button type="button" onClick={() => goToError(error)}>
                <ErrorText error={error} />
              </button>
            ) : (
              <ErrorText error={error} />
            )}
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
      <small>{error.code}</small>
    </>
  );
}
