// What the task shows to people, and the question that it asks: both are answered here.
import { useId, useMemo, useState, type ReactNode } from "react";
import type { Question } from "../../generated/messages";
import { ProgressView } from "../../page/ProgressView";
import { isWayOut } from "../../shared/display/answers";
import { limits, read } from "../../shared/display/numberText";
import { canAnswer } from "../../shared/display/page";
import { buttonTitles, titlesAsked } from "../../shared/timeline/answers";
import { activeIds } from "../../shared/timeline/progress";
import { readApplication } from "../../shared/timeline/read";
import { useSession } from "../client";
import { useTree } from "../editing";
import { answer, press, useDisplay } from "./display";
import { treeOfRun } from "./failed";
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
      {message?.progress !== undefined && <ProgressView name={message.text === "" ? texts.runView.progressOf : message.text} progress={message.progress} />}
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

const kNoTitles: ReadonlyMap<string, string> = new Map();

/** What the answers are called, if a step has failed and it is asked what now. */
function useTitles(): ReadonlyMap<string, string> {
  const tree = useTree();
  const active = useSession((s) => s.run?.active);
  const model = useSession((s) => s.model);
  return useMemo(() => {
    const run = treeOfRun({ model });
    return tree === undefined || run === undefined || active === undefined ? kNoTitles : titlesAsked(tree, readApplication(tree).root, activeIds(active, run));
  }, [tree, active, model]);
}

function QuestionHere({ question }: { readonly question: Question }) {
  const may = useDisplay(canAnswer);
  const titles = useTitles();
  return (
    <div className="question" role="group" aria-label={texts.runView.question}>
      <div role="alert">
        <h2>{question.text}</h2>
      </div>
      {"number" in question ? (
        <NumberHere id={question.id} entry={question.number} may={may} />
      ) : (
        <div className="answers">
          {question.buttons.map((button, i) => (
            <button key={button} type="button" className={isWayOut(button) ? "is-out" : "main"} disabled={!may} onClick={() => answer(question.id, button)}>
              {buttonTitles(question.buttons, titles)[i]}
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
  const why = useId();
  const outcome = read(text, entry);
  const problem = text !== "" && "problem" in outcome ? outcome.problem : undefined;
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
      <input id={label} inputMode="decimal" aria-invalid={problem !== undefined} aria-describedby={why} value={text} onChange={(event) => setText(event.target.value)} />
      <button type="submit" className="main" disabled={!may || "problem" in outcome}>
        {texts.runView.answer}
      </button>
      <p id={why} className="problem" aria-live="polite">
        {problem}
      </p>
    </form>
  );
}
