// What the page shows while no run is watched: the tasks of the server, and other ways to begin.
import { useMemo } from "react";
import { namesOf } from "../../shared/documents/listed";
import { freeDocumentName } from "../../shared/documents/names";
import { kMostStarters, starters } from "../../shared/documents/starters";
import { keysOf } from "../../shared/session/shortcuts";
import { attempt, useSession } from "../client";
import { create, showDocuments } from "../documents/actions";
import { startTour } from "../help/tour";
import { useRefusal } from "../login/rights";
import { askPairing } from "../pairing/pairing";
import { DocumentCard } from "./DocumentCard";

export function StartCards() {
  const listed = useSession((s) => s.listed);
  const offline = useSession((s) => s.connection !== "open");
  const documents = useSession((s) => s.documents);
  const shown = useMemo(() => starters(documents), [documents]);
  const refusal = useRefusal("store_document");
  if (!listed) return <p>Asking the server what runs…</p>;
  const newTask = () => void attempt(() => create(freeDocumentName("task", namesOf(documents))));
  return (
    <section className="start" aria-label="Start">
      <h2>No run is shown. Start a task:</h2>
      <ul className="start-cards" aria-label="Tasks">
        {shown.map((document) => (
          <DocumentCard key={`${document.name}/${document.revision}`} document={document} offline={offline} />
        ))}
      </ul>
      {documents.length > kMostStarters && (
        <button type="button" className="link" onClick={() => showDocuments(true)}>
          Show all {documents.length} tasks
        </button>
      )}
      <ul className="start-ways" aria-label="Other ways to begin">
        <Way title="Take the tour" text="Build a first task in six steps, and see it run." button={`Start the tour`} hint={refusal ?? `Help: ${keysOf("guide")}`} disabled={offline || refusal !== undefined} act={startTour} />
        <Way title="Build a task" text="An empty document in the editor; states come from the left." button="New task" {...(refusal !== undefined && { hint: refusal })} disabled={offline || refusal !== undefined} act={newTask} />
        <Way title="Build with skills" text="RACE One: tasks as rows of skills, without programming." button="Open RACE One" disabled={false} act={() => location.assign("/one/")} />
        <Way title="Pair a phone" text="A phone as the display of a task: it shows questions and takes answers." button="Show the code" disabled={false} act={() => askPairing(true)} />
      </ul>
    </section>
  );
}

interface WayProps {
  readonly title: string;
  readonly text: string;
  readonly button: string;
  readonly hint?: string;
  readonly disabled: boolean;
  readonly act: () => void;
}

function Way({ title, text, button, hint, disabled, act }: WayProps) {
  return (
    <li>
      <h3>{title}</h3>
      <p>{text}</p>
      <button type="button" title={hint} disabled={disabled} onClick={act}>
        {button}
      </button>
    </li>
  );
}
