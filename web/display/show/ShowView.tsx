// What tasks show on this display, and ask.
import { ProgressView } from "../../page/ProgressView";
import { isWayOut } from "../../shared/display/answers";
import { canAnswer, type DisplayPage } from "../../shared/display/page";
import type { DisplayMessage, Question } from "../../generated/messages";
import { answer, press, useDisplay } from "../client";
import { texts } from "../texts";
import { NumberQuestion } from "./NumberQuestion";

export function ShowView() {
  const page = useDisplay((now) => now);
  const { message, question } = page.content ?? {};
  return (
    <div className={question === undefined ? "show" : "show is-asking"}>
      {message !== undefined && <MessageView message={message} usable={page.connection === "open"} />}
      {question !== undefined && <QuestionView key={question.id} question={question} page={page} />}
      {message === undefined && question === undefined && page.connection === "open" && <Idle name={page.name} />}
    </div>
  );
}

/** Nothing is shown: who stands here learns what the page is for. */
function Idle({ name }: { readonly name: string }) {
  return (
    <div className="idle">
      <p className="idle-name">{name}</p>
      <p>{texts.show.idle}</p>
    </div>
  );
}

function MessageView({ message, usable }: { readonly message: DisplayMessage; readonly usable: boolean }) {
  return (
    <section aria-label={texts.show.message} className="message">
      {message.image !== undefined && <img src={message.image} alt="" />}
      {message.text !== "" && <p className="text">{message.text}</p>}
      {message.progress !== undefined && <ProgressView name={message.text === "" ? texts.show.progress : message.text} progress={message.progress} />}
      {message.buttons.map((button) => (
        <button key={button} className="plain" disabled={!usable} onClick={() => press(button)}>
          {button}
        </button>
      ))}
    </section>
  );
}

function QuestionView({ question, page }: { readonly question: Question; readonly page: DisplayPage }) {
  return (
    <section aria-label={texts.show.question} className="question">
      <h2 className="text">{question.text}</h2>
      {"number" in question ? (
        <NumberQuestion question={question} page={page} />
      ) : (
        <div className="choices">
          {question.buttons.map((button) => (
            <button key={button} className={isWayOut(button) ? "choice is-out" : "choice"} disabled={!canAnswer(page)} onClick={() => answer(question.id, button)}>
              {button}
            </button>
          ))}
        </div>
      )}
    </section>
  );
}
