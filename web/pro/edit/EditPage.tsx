// The page that edits a document: its name and state, the drawing, and what was refused.
import { useState } from "react";
import { errorsText } from "../../shared/run/errorsText";
import type { ModelTree } from "../../shared/model/modelTree";
import { ModelCanvas } from "../canvas/ModelCanvas";
import { closeDocument, perform, useEditing } from "./editing";
import { ErrorList } from "./ErrorList";
import { useEditedPlaces } from "./placing/editedPlaces";
import { Placing } from "./placing/Placing";
import { DraftList } from "./forms/DraftList";
import { StateEditor } from "./forms/StateEditor";
import { Refusals } from "./Refusals";
import { view } from "../client";

interface Props {
  readonly tree: ModelTree | undefined;
  readonly document: string | undefined;
}

export function EditPage({ tree, document }: Props) {
  const top = useEditing((now) => now.top);
  const [listed, list] = useState(true);
  const places = useEditedPlaces();
  const unreadable = useEditing((now) => now.session?.unreadable);
  const nothing = document === undefined ? "No document is open." : unreadable === undefined ? `Loading ${document}…` : `${document} cannot be edited: ${unreadable.message}`;
  return (
    <div className="edit-page">
      {document !== undefined && <EditHead document={document} listed={listed} onList={() => list(!listed)} />}
      <Refusals />
      <div className="edit-canvas">
        <ModelCanvas subject={`document ${document ?? ""} ${top ?? ""}`} tree={tree} places={places} nothing={nothing} />
        <Placing />
        <StateEditor tree={tree} />
      </div>
      {listed && <ErrorList />}
    </div>
  );
}

function close(): void {
  view.dispatch({ type: "page", page: "task" });
  closeDocument();
}

interface HeadProps {
  readonly document: string;
  /** Whether the errors are listed. */
  readonly listed: boolean;
  readonly onList: () => void;
}

function EditHead({ document, listed, onList }: HeadProps) {
  const session = useEditing((now) => now.session);
  const revision = session?.confirmed?.revision;
  const errors = session?.errors.length ?? 0;
  const waiting = session?.pending.length ?? 0;
  const depths = session?.depths;
  return (
    <header className="edit-head" aria-label="Document">
      <h2>{document}</h2>
      <span className="quiet" role="status">
        {revision === undefined ? "not here yet" : `revision ${revision}`}
        {session?.connected === false ? " · connection lost, edits wait" : waiting > 0 ? ` · ${waiting} on the way` : " · saved"}
      </span>
      {errors > 0 && (
        <button type="button" className="edit-errors" aria-expanded={listed} title={`${listed ? "Hide" : "List"} the errors; a draft cannot be started`} onClick={onList}>
          Draft, {errorsText(errors)}
        </button>
      )}
      <DraftList />
      <span className="edit-tools">
        <button type="button" disabled={depths?.undo === 0} onClick={() => perform({ undo: true })}>
          Undo
        </button>
        <button type="button" disabled={depths === undefined || depths.redo === 0} onClick={() => perform({ redo: true })}>
          Redo
        </button>
        <button type="button" onClick={close}>
          Close
        </button>
      </span>
    </header>
  );
}
