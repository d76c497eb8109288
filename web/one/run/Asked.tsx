// What the task shows to people, and the question that it asks: both are answered here.
import { useId, useState, type ReactNode } from "react";
import type { Question } from "../../generated/messages";
import { isWayOut } from "../../shared/display/answers";
import { limits, read } from "../../shared/display/numberText";
import { canAnswer } from "../../shared/display/page";
import { answer, press, useDisplay } from "./display";
import { texts } from "../texts";

/** `children`: what else can be done than to answer. */
export function Asked({ children }: { readonly children?: ReactNode }) {
  const message = useDisplay((page) => page.content?.message);
  const question = useDisplay((page) => page.content?.question);
  const open = useDisplay((page) => page.connection === "open");
  if (message === undefined && question === undefined) return null;
  return (
    <section className="asked" aria-label={texts.runView.says}>
      {message?.image !== undefined && <img src={message.image} alt="" />}
      {message !== undefined && message.text !== "" && <p className="said">{message.text}</p>}
      {message !== undefined && message.buttons.length > 0 && (
        <div className="buttons">
          {message.buttons.map((button) => (
            <button key={button} type="button" disabled={!open} onClick={() => press(button)}>
              {button}
            </button>
          ))}
        </div>
      )}
      {question !== undefined && <QuestionHere key={question.id} question={question} />}
      {question !== undefined && children !== undefined && <div className="answers">{children}</div>}
    </section>
  );
}

function QuestionHere({ question }: { readonly question: Question }) {
  const may = useDisplay(canAnswer);
  return (
    <div className="question" role="group" aria-label={texts.runView.question}>
      <div role="alert">
        <h2>{question.text}</h2>
      </div>
      {"number" in question ? (
        <NumberHere id={question.id} entry={question.number} may={may} />
      ) : (
        <div className="answers">
          {question.buttons.map((button) => (
            <button key={button} type="button" className={isWayOut(button) ? "is-out" : "main"} disabled={!may} onClick={() => answer(question.id, button)}>
              {button}
            </button>
          ))}
        </div>
      )}
    </div>
  );
}

function NumberHere({ id, entry, may }: { readonly id: number; readonly entry: Extract<Question, { readonly number: unknown }>["number"]; readonly may: boolean }) {
  const label = useId();
  const [text, setText] = useState(entry.value === undefined ? "" : String(entry.value));
  const outcome = read(text, entry);
  return (
    <form
      className="answers"
      onSubmit={(event) => {
        event.preventDefault();
        if ("value" in outcome) answer(id, outcome.value);
      }}
    >
      <label htmlFor={label}>
        {limits(entry)} {entry.unit}
      </label>
      <input id={label} inputMode="decimal" value={text} onChange={(event) => setText(event.target.value)} />
      <button type="submit" className="main" disabled={!may || "problem" in outcome}>
        {texts.runView.answer}
      </button>
    </form>
  );
}
