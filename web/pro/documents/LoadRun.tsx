// The buttons that make a run of a document: at once, or with arguments.
import { useEffect, useState } from "react";
import { afterFirstDrawing } from "../canvas/firstDrawing";
import { parametersOf } from "../runCommands";
import { useIsMaking } from "../../page/starting";
import { useRefusal } from "../login/rights";
import { ArgumentsForm } from "./ArgumentsForm";
import { requestRun, useAsked } from "./asking";

interface Props {
  /** Its name. */
  readonly document: string | undefined;
  /** Why no run can be made of it, and the id of the element that says so. */
  readonly refusal: string | undefined;
  readonly refusalId: string;
  /** The server is not there. */
  readonly offline: boolean;
}

export function LoadRun({ document, refusal: ofDocument, refusalId, offline }: Props) {
  const ofAccount = useRefusal("make_run");
  const refusal = ofAccount ?? ofDocument;
  const [hasParameters, setHasParameters] = useState(false);
  const asked = useAsked();
  const making = useIsMaking();
  const possible = document !== undefined && refusal === undefined;

  useEffect(() => {
    if (document === undefined || !possible) return;
    let current = true;
    // A document that cannot be loaded now says so when it is asked for.
    const known = afterFirstDrawing().then(() => (current ? parametersOf(document) : []));
    void known.then((parameters) => current && setHasParameters(parameters.length > 0), () => undefined);
    return () => void (current = false);
  }, [document, possible]);

  return (
    <>
      <button
        type="button"
        disabled={!possible || offline || making}
        title={refusal}
        aria-describedby={ofDocument === undefined ? undefined : refusalId}
        onClick={() => document !== undefined && void requestRun(document, false)}
      >
        Load
      </button>
      {hasParameters && possible && (
        <button type="button" aria-haspopup="dialog" disabled={offline} title="Make a run with arguments" onClick={() => void requestRun(document, true)}>
          Arguments…
        </button>
      )}
      {asked !== undefined && <ArgumentsForm document={asked.document} parameters={asked.parameters} />}
    </>
  );
}
