// What is in a state: its children in their order, where it begins, and how it decides where to begin.
import { childConflicts } from "../../../shared/edit/order";
import { removeRow } from "../../../shared/edit/commands/rows";
import { setField } from "../../../shared/edit/commands/setField";
import { keyOf, type State } from "../../../shared/model/model";
import { perform } from "../editing";
import { ChoiceField } from "./ChoiceField";
import { moveTo } from "./ElementRows";
import { FieldErrors } from "./FieldErrors";
import { OracleField } from "./OracleField";
import { Rows } from "./Rows";
import { selectById } from "./selectById";

export function ChildRows({ state }: { readonly state: State }) {
  const { id = "", children } = state;
  if (children.length === 0) return null;
  const conflicts = childConflicts(state);
  const items = children.map((child) => ({
    id: child.id ?? "", name: child.name,
    content: (
      <button type="button" className="link child-name" onClick={() => selectById(child.id ?? "")}>
        {keyOf(child)}
        {child.kind === "barrier" && <small> barrier</small>}
      </button>
    ),
  }));
  const first = [{ value: "", text: "nothing" }, ...children.map(({ name }) => ({ value: name, text: name }))];
  return (
    <>
      <Rows label={conflicts.size > 0 ? "Children, in order of evaluation" : "Children"} one="child" items={items} numbered={conflicts} className="is-children" onRemove={(child) => perform(removeRow(child))} onMove={moveTo} />
      <div className="form-section">
        <ChoiceField label="Begins with" value={state.first ?? ""} place={`${id}/first`} choices={first} onChoose={(name) => perform(setField(id, "first", name === "" ? undefined : name))} />
        <FieldErrors id={id} field="first" />
        <OracleField state={state} />
      </div>
    </>
  );
}
