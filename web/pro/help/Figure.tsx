// A figure of the help: the example, drawn as the canvas draws; it can be stored as a document of one's own.
import { useMemo } from "react";
import { freeDocumentName } from "../../shared/documents/names";
import { namesOf } from "../../shared/documents/listed";
import type { Example } from "../../shared/help/examples";
import { exampleState } from "../../shared/help/exampleState";
import { StateFigure, type Pictured } from "../canvas/StateFigure";
import { createFrom } from "../documents/actions";
import { useAttempt } from "../documents/useAttempt";
import { useSession } from "../client";
import { useRefusal } from "../login/rights";

interface Props {
  readonly example: Example;
  readonly caption: string;
}

const kNone: ReadonlySet<string> = new Set();

export function Figure({ example, caption }: Props) {
  const documents = useSession((s) => s.documents);
  const { attempt, reason, busy } = useAttempt();
  const refusal = useRefusal("store_document");
  const offline = useSession((s) => s.connection !== "open");
  const pictured = useMemo<Pictured>(() => ({ state: exampleState(example), collapsed: kNone, detail: "full" }), [example]);
  const name = freeDocumentName(example.name, namesOf(documents));
  return (
    <figure className="help-figure">
      <div className="help-drawing">
        <StateFigure of={pictured} title={caption} />
      </div>
      <figcaption>
        {caption}
        <button type="button" className="link" disabled={offline || busy || refusal !== undefined} title={refusal} onClick={() => void attempt(() => createFrom(name, example.document))}>
          Open as a document of your own
        </button>
      </figcaption>
      {reason !== undefined && (
        <p className="bad" role="alert">
          {reason}
        </p>
      )}
    </figure>
  );
}
