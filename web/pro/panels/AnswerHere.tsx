// The answers to a question that a run waits for, in place. A way out does not look like a way on.
import { useState } from "react";
import { isWayOut } from "../../shared/display/answers";
import type { Answers, PersonWait } from "../../shared/run/waitingForPerson";
import { useSession } from "../client";
import { useAttempt } from "../documents/useAttempt";
import { useRefusal } from "../login/rights";
import { giveAnswer } from "./answering";

export function AnswerHere({ wait, answers }: { readonly wait: PersonWait; readonly answers: Answers }) {
  const attempts = useAttempt();
  const { attempt, reason } = attempts;
  const lost = useSession((s) => s.connection === "lost");
  const refusal = useRefusal("answer");
  const busy = attempts.busy || lost || refusal !== undefined;
  const give = (answer: string | number) => void attempt(() => giveAnswer(wait, answer));
  return (
    <div className="answers" role="group" aria-label="Answers">
      {"number" in answers ? (
        <NumberAnswer number={answers.number} busy={busy} give={give} />
      ) : (
        answers.buttons.map((text) => (
          <button key={text} type="button" className={isWayOut(text) ? "is-out" : ""} disabled={busy} title={refusal} onClick={() => give(text)}>
            {text}
          </button>
        ))
      )}
      {refusal !== undefined && <p>You cannot answer: {refusal}.</p>}
      {reason !== undefined && <p role="alert">Not answered: {reason}</p>}
    </div>
  );
}

interface NumberProps {
  readonly number: Extract<Answers, { readonly number: unknown }>["number"];
  readonly busy: boolean;
  readonly give: (answer: number) => void;
}

function NumberAnswer({ number: { min, max, unit, initial }, busy, give }: NumberProps) {
  const [text, setText] = useState(initial === undefined ? "" : String(initial));
  const value = text.trim() === "" ? Number.NaN : Number(text);
  const isValid = value >= min && value <= max;
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        if (isValid) give(value);
      }}
    >
      <label>
        {min} to {max} {unit} <input type="text" inputMode="decimal" value={text} aria-label="Number" aria-invalid={text !== "" && !isValid} onChange={(event) => setText(event.target.value)} />
      </label>
      <button type="submit" disabled={busy || !isValid}>
        Answer
      </button>
    </form>
  );
}
