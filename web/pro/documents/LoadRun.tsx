// The buttons that make a run of a document: at once, or with arguments.
import { useEffect, useState } from "react";
import { parametersOf } from "../client";
import { ArgumentsForm } from "./ArgumentsForm";
import { requestRun, useAsked } from "./asking";

interface Props {
  /** Its name. */
  readonly document: string | undefined;
  /** Why no run can be made of it, and the id of the element that says so. */
  readonly refusal: string | undefined;
  readonly refusalId: string;
}

export function LoadRun({ document, refusal, refusalId }: Props) {
  const [hasParameters, setHasParameters] = useState(false);
  const asked = useAsked();
  const possible = document !== undefined && refusal === undefined;

  useEffect(() => {
    if (document === undefined || !possible) return;
    let current = true;
    // A document that cannot be loaded now says so when it is asked for.
    void parametersOf(document).then((parameters) => current && setHasParameters(parameters.length > 0), () => undefined);
    return () => void (current = false);
  }, [document, possible]);

  return (
    <>
      <button
        type="button"
        disabled={!possible}
        title={refusal}
        aria-describedby={refusal === undefined ? undefined : refusalId}
        onClick={() => document !== undefined && void requestRun(document, false)}
      >
        Load
      </button>
      {hasParameters && possible && (
        <button type="button" aria-haspopup="dialog" title="Make a run with arguments" onClick={() => void requestRun(document, true)}>
          Arguments…
        </button>
      )}
      {asked !== undefined && <ArgumentsForm document={asked.document} parameters={asked.parameters} />}
    </>
  );
}
