// How the connection is, what is in the way, and that a question waits in another view.
import { dismissProblem, useDisplay, useRefusal, useSession } from "./client";
import { goTo, usePlace } from "./place";

export function Status() {
  const page = useDisplay((now) => now);
  const view = usePlace((place) => place.view);
  const refusal = useRefusal("be_display");
  const problem = useSession((now) => now.problem);
  const isLost = useSession((now) => now.connection === "lost");
  const refused = refusal === undefined ? page.problem : `This page is no display: ${refusal}.`;
  return (
    <header>
      <div className="line">
        <h1 className="name">{page.name}</h1>
        <span role="status" aria-label="Connection" className={page.connection === "open" ? "is-open" : "is-closed"}>
          {page.connection === "open" ? "Connected" : isLost ? "Connection lost" : "Connecting"}
        </span>
      </div>
      {refused !== undefined && <p className="notice is-bad">{refused}</p>}
      {problem !== undefined && (
        <p className="notice is-bad has-button" role="alert">
          <span>{problem}</span>
          <button type="button" className="plain" onClick={dismissProblem}>
            OK
          </button>
        </p>
      )}
      {view === "show" && !page.sound && <p className="notice">Touch the screen once to hear sounds.</p>}
    </header>
  );
}

/** A task waits for a person who looks at something else. */
export function Asking() {
  const question = useDisplay((page) => page.content?.question);
  if (question === undefined) return null;
  return (
    <section className="notice is-question has-button" aria-label="A task asks">
      <p role="alert">{question.text}</p>
      <button type="button" className="choice" onClick={() => goTo({ view: "show" })}>
        Answer
      </button>
    </section>
  );
}
