// How the connection is, what is in the way, and that a question waits in another view.
import { dismissProblem, useDisplay, useRefusal, useSession } from "./client";
import { goTo, usePlace } from "./place";
import { texts } from "./texts";

export function Status() {
  const page = useDisplay((now) => now);
  const view = usePlace((place) => place.view);
  const isLost = useSession((now) => now.connection === "lost");
  return (
    <header>
      <div className="line">
        <h1 className="name">{page.name}</h1>
        <span role="status" aria-label={texts.frame.connection} className={page.connection === "open" ? "is-open" : "is-closed"}>
          {page.connection === "open" ? texts.frame.connected : isLost ? texts.frame.connectionLost : texts.frame.connecting}
        </span>
      </div>
      {view !== "move" && <Problems />}
      {view === "show" && !page.sound && <p className="notice">{texts.frame.touch}</p>}
    </header>
  );
}

/** What was not done, and why this page is no display. Where the robot is moved by hand, they are among its notes (control/HandNotes.tsx), as a question is. */
export function Problems() {
  const refusal = useRefusal("be_display");
  const broken = useDisplay((page) => page.problem);
  const problem = useSession((now) => now.problem);
  const refused = refusal === undefined ? broken : texts.frame.noDisplay(refusal);
  return (
    <>
      {refused !== undefined && <p className="notice is-bad">{refused}</p>}
      {problem !== undefined && (
        <p className="notice is-bad has-button" role="alert">
          <span>{problem}</span>
          <button type="button" className="plain" onClick={dismissProblem}>
            {texts.frame.ok}
          </button>
        </p>
      )}
    </>
  );
}

/** A task waits for a person who looks at something else. */
export function Asking() {
  const question = useDisplay((page) => page.content?.question);
  if (question === undefined) return null;
  return (
    <section className="notice is-question has-button" aria-label={texts.frame.asks}>
      <p role="alert">{question.text}</p>
      <button type="button" className="choice" onClick={() => goTo({ view: "show" })}>
        {texts.frame.answer}
      </button>
    </section>
  );
}
