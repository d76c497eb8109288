// A task of the server with its picture: what it does, and the ways to start and to open it.
import { useEffect, useState } from "react";
import type { DocumentSummary } from "../../generated/messages";
import { buildTree } from "../../shared/model/modelTree";
import { errorsText } from "../../shared/run/errorsText";
import { errorCount, refusalToStart } from "../../shared/session/draft";
import { api } from "../client";
import { StateFigure, type Pictured } from "../canvas/StateFigure";
import { edit } from "../documents/actions";
import { requestRun } from "../documents/asking";
import { useIsMaking } from "../../page/starting";
import { useRefusalToStart } from "../login/rights";
import { CodeText } from "../panels/CodeText";

/** The first level of the task: what is inside of its states is left out. */
async function picture(name: string): Promise<Pictured> {
  const { root } = await api.documentModel(name);
  const inner = [...buildTree(root).values()].filter(({ depth, children }) => depth > 0 && children.length > 0);
  return { state: root, collapsed: new Set(inner.map(({ path }) => path)), detail: "slim" };
}

interface Props {
  readonly document: DocumentSummary;
  readonly offline: boolean;
}

export function DocumentCard({ document, offline }: Props) {
  const { name, doc } = document;
  const errors = errorCount(document);
  const [pictured, setPictured] = useState<Pictured>();
  const starting = useIsMaking();
  const refusal = useRefusalToStart() ?? refusalToStart(document);
  useEffect(() => {
    if (errors > 0) return;
    let current = true;
    // Without a picture, the card says what there is to say.
    picture(name).then((next) => current && setPictured(next), () => undefined);
    return () => void (current = false);
  }, [name, errors]);
  return (
    <li aria-label={name}>
      <div className="start-picture">{pictured === undefined ? <p className="quiet">{errors > 0 ? `A draft with ${errorsText(errors)}` : "Drawing…"}</p> : <StateFigure of={pictured} title={`The states of ${name}`} />}</div>
      <h3>{name}</h3>
      <p>{doc === undefined ? "It has no description." : <CodeText text={doc} />}</p>
      <div className="start-actions">
        <button type="button" className="lead" disabled={offline || starting || refusal !== undefined} title={refusal} onClick={() => void requestRun(name, false, true)}>
          Start
        </button>
        <button type="button" disabled={offline} onClick={() => edit(name)}>
          Open
        </button>
      </div>
    </li>
  );
}
