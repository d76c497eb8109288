// The form for the arguments of a run; the keys of the page do nothing meanwhile. What is wrong stands under its field, and what the server refuses under them all; then nothing is made.
import { useState, type SyntheticEvent } from "react";
import { useModal } from "../../page/useModal";
import { readArguments } from "../../shared/arguments/entry";
import { useRefusalToStart } from "../login/rights";
import { makeRun } from "../runCommands";
import { makeStarted } from "../panels/startAsk";
import { ArgumentField } from "./ArgumentField";
import { closeForm, type Asked } from "./asking";
import { messageOf } from "../../shared/messageOf";

type Texts = Readonly<Record<string, string>>;
const kNone: Texts = {};

export function ArgumentsForm({ document, parameters }: Asked) {
  const dialog = useModal();
  const [texts, setTexts] = useState(kNone);
  const [problems, setProblems] = useState(kNone);
  const [refusal, setRefusal] = useState<string>();
  const [busy, setBusy] = useState(false);
  const cannotStart = useRefusalToStart();

  const close = () => dialog.current?.close();
  const change = (name: string, text: string) => {
    setTexts({ ...texts, [name]: text });
    setProblems(Object.fromEntries(Object.entries(problems).filter(([other]) => other !== name)));
  };
  const make = async (start: boolean) => {
    const read = readArguments(parameters, texts);
    setProblems("problems" in read ? read.problems : kNone);
    setRefusal(undefined);
    if ("problems" in read) {
      const wrong = parameters.find(({ name }) => Object.hasOwn(read.problems, name));
      dialog.current?.querySelector<HTMLElement>(`[name="${wrong?.name ?? ""}"]`)?.focus();
      return;
    }
    setBusy(true);
    try {
      // The question can have the focus only once this form is closed.
      if (start) await makeStarted(document, read.values, close);
      else await makeRun(document, false, read.values).then(close);
    } catch (error) {
      setRefusal(messageOf(error));
      setBusy(false);
    }
  };
  const submit = (event: SyntheticEvent<HTMLFormElement>) => {
    event.preventDefault();
    if (busy) return;
    const button = event.nativeEvent instanceof SubmitEvent ? event.nativeEvent.submitter : null;
    void make(button instanceof HTMLButtonElement && button.value === "start");
  };
  return (
    <dialog ref={dialog} className="arguments" aria-label={`Arguments of ${document}`} onClose={closeForm} onKeyDown={(event) => event.stopPropagation()}>
      <form noValidate onSubmit={submit}>
        <h2>
          Arguments of <code>{document}</code>
        </h2>
        <div className="arguments-fields">
          {parameters.map((parameter) => (
            <ArgumentField key={parameter.name} parameter={parameter} text={texts[parameter.name]} problem={problems[parameter.name]} onChange={(text) => change(parameter.name, text)} />
          ))}
        </div>
        {refusal !== undefined && (
          <p className="arguments-refusal" role="alert">
            {refusal}
          </p>
        )}
        <div className="arguments-buttons">
          <button type="button" onClick={close}>
            Cancel
          </button>
          <button type="submit" value="load" disabled={busy}>
            Load
          </button>
          <button type="submit" value="start" className="is-main" disabled={busy || cannotStart !== undefined} title={cannotStart}>
            Load and start
          </button>
        </div>
      </form>
    </dialog>
  );
}
