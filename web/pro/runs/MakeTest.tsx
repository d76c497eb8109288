// A test of a run that is over, saved as a file for `race test`: its button in a row or card, and what is told of it there.
import { useEffect, useRef, useState } from "react";
import { modelFileOf, testFileOf } from "../../shared/runs/testFile";
import { useSession } from "../client";
import { useAttempt } from "../documents/useAttempt";
import { saveTest } from "./actions";

interface Props {
  /** Of the run. */
  readonly id: string;
  readonly document: string;
}

interface ButtonProps extends Props {
  readonly disabled: boolean;
  /** Does it, or tells why it has failed. */
  readonly attempt: (action: () => Promise<void>) => Promise<void>;
  readonly onSaved: (saved: boolean) => void;
}

export function MakeTestButton({ id, document, disabled, attempt, onSaved }: ButtonProps) {
  const make = async () => {
    onSaved(false);
    await saveTest(id, document);
    onSaved(true);
  };
  return (
    <button type="button" disabled={disabled} title={`Saves ${testFileOf(document)}: that the task comes to the same by the same inputs`} onClick={() => void attempt(make)}>
      Make a test
    </button>
  );
}

export function SavedTest({ document }: { readonly document: string }) {
  return (
    <p className="saved-test" role="status">
      Saved as <code>{testFileOf(document)}</code>: put it beside <code>{modelFileOf(document)}</code> and the files of its cell, and <code>race test {testFileOf(document)}</code> runs it.
    </p>
  );
}

/** Of the run that is shown. */
export function MakeTest({ id, document }: Props) {
  const offline = useSession((s) => s.connection !== "open");
  const { attempt, reason, busy } = useAttempt();
  const [saved, setSaved] = useState(false);
  const element = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (saved || reason !== undefined) element.current?.scrollIntoView({ block: "nearest" });
  }, [saved, reason]);
  return (
    <div className="make-test" ref={element}>
      <MakeTestButton id={id} document={document} disabled={offline || busy} attempt={attempt} onSaved={setSaved} />
      {saved && <SavedTest document={document} />}
      {reason !== undefined && (
        <p className="bad" role="alert">
          {reason}
        </p>
      )}
    </div>
  );
}
