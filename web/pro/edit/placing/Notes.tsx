// Notes as sticky notes at what they are about. In a small drawing, and where they would cover something else, they are marks, which open
// with the pointer or the focus.
import { useState, type KeyboardEvent } from "react";
import { drawnBox } from "../../../shared/drawing/drawnBox";
import { noteCorner } from "../../../shared/drawing/notePlaces";
import { writeNote } from "../../../shared/edit/commands/placing";
import { selectionsOf, type Selection } from "../../../shared/model/identity";
import { CanvasLayer } from "../../canvas/CanvasLayer";
import { useShownCanvas } from "../../canvas/canvasView";
import { pathOf } from "../../../shared/session/view";
import { view } from "../../client";
import { refusalNow } from "../../login/rights";
import { carryOut } from "../carryOut";
import { editedDocument } from "../editing";
import { useNotes } from "./editedPlaces";
import { editNote, useWritten } from "./noted";

const nameOf = (selection: Selection): string => (selection.kind === "node" ? selection.path : selection.address);

export function Notes() {
  const laid = useShownCanvas()?.laid;
  const notes = useNotes();
  const written = useWritten();
  if (laid === undefined) return null;
  const selections = selectionsOf(laid.tree);
  const ids = written === undefined || written in notes ? Object.keys(notes) : [...Object.keys(notes), written];
  return (
    <CanvasLayer className="notes">
      {ids.map((id) => {
        const selection = selections.get(id);
        const box = selection && drawnBox(laid.drawing, selection);
        if (selection === undefined || box === undefined) return null;
        const text = notes[id] ?? "";
        const corner = written === id ? "above" : noteCorner(laid.drawing, pathOf(selection), box, text);
        return (
          <div key={id} className={`note-place is-${corner ?? "mark"}`} style={{ left: box.x, top: box.y, width: box.width, height: box.height }}>
            {written === id ? <NoteField id={id} name={nameOf(selection)} text={text} /> : <Note id={id} selection={selection} text={text} />}
          </div>
        );
      })}
    </CanvasLayer>
  );
}

function Note({ id, selection, text }: { readonly id: string; readonly selection: Selection; readonly text: string }) {
  return (
    <button
      type="button"
      className="note"
      aria-label={`Note on ${nameOf(selection)}: ${text}`}
      title="Double click or Shift+F2: change it"
      onClick={() => view.dispatch({ type: "select", selection })}
      onDoubleClick={() => refusalNow("edit") === undefined && editNote(id)}
    >
      <span>{text}</span>
    </button>
  );
}

function NoteField({ id, name, text }: { readonly id: string; readonly name: string; readonly text: string }) {
  const [value, setValue] = useState(text);
  const close = () => editNote(undefined);
  const commit = () => {
    const document = editedDocument();
    const command = document === undefined ? undefined : writeNote(document, id, value);
    // A note that is left as it was is no edit.
    if (command !== undefined && "change" in command) carryOut(command);
    close();
  };
  const press = (event: KeyboardEvent) => {
    event.stopPropagation();
    if (event.key === "Escape") close();
    else if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) commit();
  };
  return (
    <textarea
      className="note note-field"
      aria-label={`Note on ${name}`}
      placeholder="A note. Ctrl+Enter keeps it, Esc does not."
      value={value}
      rows={4}
      autoFocus
      onChange={(event) => setValue(event.target.value)}
      onKeyDown={press}
      onBlur={commit}
    />
  );
}
