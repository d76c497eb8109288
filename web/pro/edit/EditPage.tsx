// The page that edits a document: its name and state, the drawing, and what was refused.
import { useEffect, useState } from "react";
import type { ServerError } from "../../generated/messages";
import { errorsText } from "../../shared/run/errorsText";
import type { ModelTree } from "../../shared/model/modelTree";
import { ModelCanvas } from "../canvas/ModelCanvas";
import { loadCodeEditor } from "../code/CodeField";
import { CommentCount, CommentList } from "../comments/CommentList";
import { CommentMarks } from "../comments/CommentMarks";
import { CoverageMarks } from "../coverage/CoverageMarks";
import { useCoverageShown } from "../coverage/coverage";
import { runAction } from "./actions/action";
import { actionOf } from "./actions/registry";
import { useActionKeys } from "./actions/useActionKeys";
import { perform, showTop, useEditing } from "./editing";
import { ErrorList } from "./ErrorList";
import { DragLayer } from "./gestures/DragLayer";
import { EditCanvas } from "./gestures/EditCanvas";
import { MissingDocument } from "./MissingDocument";
import { Prompts } from "./prompts/Prompts";
import { Splitter } from "../layout/Splitter";
import { DifferenceMarks } from "../live/DifferenceMarks";
import { useCompared } from "../live/executed";
import { LiveBar } from "../live/LiveBar";
import { useRefusal } from "../login/rights";
import { DraftList } from "./forms/DraftList";
import { StateEditor } from "./forms/StateEditor";
import { useEditedPlaces } from "./placing/editedPlaces";
import { Placing, PlacingTools } from "./placing/Placing";
import { Faces } from "../presence/Faces";
import { Others } from "../presence/Others";
import { Refusals } from "./Refusals";
import { UsageList } from "./usages/UsageList";
import { useComparedVersions } from "../versions/compared";
import { useHistory } from "../versions/history";
import { useView } from "../client";
import { nameOfElement } from "../../shared/edit/commands/command";

interface Props {
  readonly tree: ModelTree | undefined;
  readonly document: string | undefined;
}

export function EditPage({ tree, document }: Props) {
  const top = useEditing((now) => now.top);
  const [listed, list] = useState(true);
  const places = useEditedPlaces();
  const unreadable = useEditing((now) => now.session?.unreadable);
  const nothing = document === undefined ? "No document is open." : unreadable === undefined ? `Loading ${document}…` : <Unreadable document={document} error={unreadable} />;
  useActionKeys();
  // Where it cannot be loaded, the fields are plain ones.
  useEffect(() => void loadCodeEditor().catch(() => undefined), []);
  return (
    <div className="edit-page">
      {document !== undefined && <EditHead document={document} listed={listed} onList={() => list(!listed)} />}
      <LiveBar />
      <Refusals />
      <EditCanvas document={document}>
        <StateEditor tree={tree} />
        <ModelCanvas subject={`document ${document ?? ""} ${top ?? ""}`} tree={tree} places={places} nothing={nothing}>
          <PlacingTools />
        </ModelCanvas>
        <Placing />
        <ShownDifference />
        <CoverageMarks />
        <CommentMarks />
        <Others />
      </EditCanvas>
      <div className="edit-lists">
        <Splitter panel="list" at="top" />
        {listed && <ErrorList />}
        <CommentList />
        <UsageList />
      </div>
      <DragLayer />
      <Prompts />
    </div>
  );
}

function Unreadable({ document, error }: { readonly document: string; readonly error: ServerError }) {
  return error.code === "not_found" ? <MissingDocument document={document} /> : `${document} cannot be edited: ${error.message}`;
}

/** Signs of what is compared in the history; else of what the run does not execute. */
function ShownDifference() {
  const versions = useComparedVersions();
  const live = useCompared();
  const isRunShown = useView((v) => v.runShown);
  const compared = versions ?? (isRunShown ? live : undefined);
  return compared === undefined || "reason" in compared ? null : <DifferenceMarks compared={compared} />;
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
  const refusal = useRefusal("edit");
  return (
    <header className="edit-head" aria-label="Document">
      <h2>{document}</h2>
      <LibraryPlace />
      <span className="quiet" role="status">
        {revision === undefined ? (session?.unreadable === undefined ? "not here yet" : "cannot be edited") : `revision ${revision}`}
        {session?.connected === false ? " · connection lost, edits wait" : waiting > 0 ? ` · ${waiting} on the way` : revision === undefined ? "" : " · saved"}
      </span>
      {refusal !== undefined && (
        <span className="read-only" title={refusal}>
          Read only
        </span>
      )}
      {errors > 0 && (
        <button type="button" className="edit-errors" aria-expanded={listed} title={`${listed ? "Hide" : "List"} the errors; a draft cannot be started`} onClick={onList}>
          Draft, {errorsText(errors)}
        </button>
      )}
      <CommentCount />
      <DraftList />
      <Faces />
      <span className="edit-tools">
        <button type="button" disabled={depths?.undo === 0 || refusal !== undefined} title={refusal} onClick={() => perform({ undo: true })}>
          Undo
        </button>
        <button type="button" disabled={depths === undefined || depths.redo === 0 || refusal !== undefined} title={refusal} onClick={() => perform({ redo: true })}>
          Redo
        </button>
        <HistoryButton />
        <CoverageButton />
        <a className="link" href={`/one/?edit=${encodeURIComponent(document)}`} title="As tasks and skills, in RACE One">
          One
        </a>
        <button type="button" onClick={() => runAction(actionOf("close"))}>
          Close
        </button>
      </span>
    </header>
  );
}

function HistoryButton() {
  const shown = useHistory((now) => now.shown);
  const action = actionOf("history");
  return (
    <button type="button" aria-pressed={shown} title={`${action.name} (${action.keys[0] ?? ""})`} onClick={() => runAction(action)}>
      History
    </button>
  );
}

function CoverageButton() {
  const shown = useCoverageShown();
  const action = actionOf("coverage");
  return (
    <button type="button" aria-pressed={shown} title={`${action.name} (${action.keys[0] ?? ""})`} onClick={() => runAction(action)}>
      Coverage
    </button>
  );
}

/** Which state of the library is shown, and the way back. */
function LibraryPlace() {
  const tree = useEditing((now) => now.session?.view);
  const top = useEditing((now) => now.top);
  if (tree === undefined || top === undefined || !tree.library.includes(top)) return null;
  return (
    <nav className="edit-place" aria-label="Library state">
      <button type="button" className="link" onClick={() => showTop(undefined)}>
        ← {nameOfElement(tree, tree.root)}
      </button>
      <span>Library state {nameOfElement(tree, top)}</span>
    </nav>
  );
}
