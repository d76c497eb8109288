// A question for a number: a keypad for touch, and why the entry is not valid yet.
import { canAnswer, type DisplayPage } from "../../shared/display/page";
import { limits, read, type Key } from "../../shared/display/numberText";
import type { Question } from "../../generated/messages";
import { answer, key as press } from "../client";
import { texts } from "../texts";

interface Props {
  readonly question: Extract<Question, { readonly number: unknown }>;
  readonly page: DisplayPage;
}

const kKeys: readonly Key[] = ["1", "2", "3", "4", "5", "6", "7", "8", "9"];

export function NumberQuestion({ question, page }: Props) {
  const entry = question.number;
  const outcome = read(page.entry, entry);
  const key = (which: Key, text: string, name = text) => (
    <button key={which} className="key" aria-label={name} onClick={() => press(which)}>
      {text}
    </button>
  );
  return (
    <>
      <output aria-label={texts.show.number} className="entry">
        {page.entry === "" ? <span className="soft">{limits(entry)}</span> : page.entry}
        {page.entry !== "" && entry.unit !== "" && <span className="unit">{entry.unit}</span>}
      </output>
      <p className="hint" aria-live="polite">
        {page.entry !== "" && ("problem" in outcome ? outcome.problem : limits(entry))}
      </p>
      <div className="keypad">
        {kKeys.map((each) => key(each, each))}
        {key(".", ".", texts.show.point)}
        {key("0", "0")}
        {key("back", "⌫", texts.show.back)}
        {entry.min < 0 && key("sign", "±", texts.show.sign)}
        <button
          className="choice"
          disabled={!canAnswer(page) || "problem" in outcome}
          onClick={() => "value" in outcome && answer(question.id, outcome.value)}
        >
          {texts.show.ok}
        </button>
      </div>
    </>
  );
}
