// A selected state: all of it, or, while the state editor shows its interface, functions and ports, the rest.
import { kOfState } from "../../../shared/debugger/places";
import type { State } from "../../../shared/model/model";
import { CommentSection } from "../../comments/CommentSection";
import { BreakpointChoices } from "../../debugger/BreakpointChoices";
import { useEditing } from "../editing";
import { ChildRows } from "./ChildRows";
import { DataRows } from "./DataRows";
import { ElementHead } from "./ElementHead";
import { ElementText } from "./ElementText";
import { FunctionFields } from "./FunctionFields";
import { KeepField } from "./KeepField";
import { LinkField } from "./LinkField";
import { PortRows } from "./PortFields";
import { closeStateEditor, openStateEditor, useStateEditor } from "./stateEditor";
import { useOwner } from "./useOwner";

export function StateForm({ state }: { readonly state: State }) {
  const { id = "" } = state;
  const isWide = useStateEditor();
  const isRoot = useEditing(({ session }) => session?.view?.root === id);
  const isOfLibrary = useEditing(({ session }) => session?.view?.library.includes(id) === true);
  return (
    <div className="form">
      <ElementHead id={id} kind={isRoot ? "Root state" : isOfLibrary ? "State of the library" : "State"} owner={useOwner(id)}>
        <button type="button" className="form-wide" aria-pressed={isWide} title="Functions, ports and parameters side by side" onClick={isWide ? closeStateEditor : openStateEditor}>
          Wide form
        </button>
      </ElementHead>
      <ElementText id={id} field="doc" label="Description" kind="lines" isBare placeholder="What it does" />
      <BreakpointChoices kinds={kOfState} />
      {!isWide && <DataRows state={state} />}
      {!isWide && <Functions state={state} />}
      {!isWide && <PortRows state={state} />}
      <ChildRows state={state} />
      <section className="form-section" aria-label="Behaviour">
        {!isRoot && <LinkField state={state} />}
        {state.link === undefined && <KeepField state={state} />}
      </section>
      <CommentSection id={id} />
    </div>
  );
}

/** A linking state has the library's, and none of its own. */
export function Functions({ state }: { readonly state: State }) {
  const hasNone = state.entry === undefined && state.exit === undefined && state.actions.length === 0;
  return state.link !== undefined && hasNone ? null : <FunctionFields state={state} />;
}
