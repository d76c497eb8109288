// The whole page: message, question, and state of the connection.
import { canAnswer, type DisplayPage } from "../shared/display/page";
import { isWayOut } from "../shared/display/answers";
import type { DisplayMessage, Question } from "../generated/messages";
import type { Actions } from "./client";
import { ControlBar } from "../control/ControlBar";
import { StoppedBanner } from "../stop/StoppedBanner";
import { NumberQuestion } from "./NumberQuestion";
import { ProgressView } from "./ProgressView";

interface Props {
  readonly page: DisplayPage;
  readonly actions: Actions;
}

export function App({ page, actions }: Props) {
  const { message, question } = page.content ?? {};
  return (
    <>
      <StoppedBanner refusal={actions.resetRefusal} fetcher={actions.fetcher} />
      <ControlBar always address={actions.controls} refusal={actions.takeRefusal} refusalToAnswer={actions.answerRefusal} fetcher={actions.fetcher} />
      <div className="display" data-connection={page.connection}>
        <Status page={page} />
        <main className={question === undefined ? "" : "is-asking"}>
          {message !== undefined && <MessageView message={message} actions={actions} usable={page.connection === "open"} />}
          {question !== undefined && <QuestionView key={question.id} question={question} page={page} actions={actions} />}
          {message === undefined && question === undefined && page.connection === "open" && <p className="idle">{page.name}</p>}
        </main>
      </div>
    </>
  );
}

function Status({ page }: { readonly page: DisplayPage }) {
  const lost = page.connection === "lost" || (page.connection === "connecting" && page.content !== undefined);
  return (
    <header>
      <div className="line">
        <h1 className="name">{page.name}</h1>
        <span role="status" aria-label="Connection" className={page.connection === "open" ? "is-open" : "is-closed"}>
          {page.connection === "open" ? "Connected" : lost ? "Connection lost" : "Connecting"}
        </span>
      </div>
      {lost && <p className="notice is-bad">Connection lost. Trying again…</p>}
      {page.problem !== undefined && <p className="notice is-bad">{page.problem}</p>}
      {!page.sound && <p className="notice">Touch the screen once to hear sounds.</p>}
    </header>
  );
}

function MessageView({ message, actions, usable }: { readonly message: DisplayMessage; readonly actions: Actions; readonly usable: boolean }) {
  return (
    <section aria-label="Message" className="message">
      {message.image !== undefined && <img src={message.image} alt="" />}
      {message.text !== "" && <p className="text">{message.text}</p>}
      {message.progress !== undefined && <ProgressView text={message.text} progress={message.progress} />}
      {message.buttons.map((button) => (
        <button key={button} className="plain" disabled={!usable} onClick={() => actions.press(button)}>
          {button}
        </button>
      ))}
    </section>
  );
}

interface QuestionProps extends Props {
  readonly question: Question;
}

function QuestionView({ question, page, actions }: QuestionProps) {
  return (
    <section aria-label="Question" className="question">
      <h2 className="text">{question.text}</h2>
      {"number" in question ? (
        <NumberQuestion question={question} page={page} actions={actions} />
      ) : (
        <div className="choices">
          {question.buttons.map((button) => (
            <button key={button} className={isWayOut(button) ? "choice is-out" : "choice"} disabled={!canAnswer(page)} onClick={() => actions.answer(question.id, button)}>
              {button}
            </button>
          ))}
        </div>
      )}
    </section>
  );
}
