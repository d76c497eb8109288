// A selected barrier: the states that it leads to, in their order.
import { nameOfElement } from "../../../shared/edit/commands/command";
import { setField } from "../../../shared/edit/commands/setField";
import { elementOf, listOf } from "../../../shared/edit/tree";
import type { Barrier } from "../../../shared/model/model";
import { CommentSection } from "../../comments/CommentSection";
import { perform, useEditing } from "../editing";
import { ChoiceField } from "./ChoiceField";
import { ElementHead } from "./ElementHead";
import { FieldErrors } from "./FieldErrors";
import { Rows } from "./Rows";
import { selectById } from "./selectById";
import { useOwner } from "./useOwner";

export function BarrierForm({ barrier }: { readonly barrier: Barrier }) {
  const { id = "", to } = barrier;
  const tree = useEditing(({ session }) => session?.view);
  const owner = useOwner(id);
  if (tree === undefined || owner === undefined) return null;
  const states = listOf(tree, owner.id, "children").filter((each) => elementOf(tree, each).kind === "state");
  const idOf = (name: string) => states.find((each) => nameOfElement(tree, each) === name);
  const remove = (name: string) => {
    const state = idOf(name);
    perform(state === undefined ? setField(id, "to", to.filter((each) => each !== name)) : { compound: { kind: "disconnect", barrier: id, state } });
  };
  const move = (name: string, at: number) => {
    const others = to.filter((each) => each !== name);
    perform(setField(id, "to", [...others.slice(0, at), name, ...others.slice(at)]));
  };
  const add = (name: string) => {
    const state = idOf(name);
    if (state !== undefined) perform({ compound: { kind: "connect", from: id, to: state } });
  };
  const free = states.map((each) => nameOfElement(tree, each)).filter((name) => !to.includes(name));
  const items = to.map((name) => ({
    id: name, name,
    content: (
      <button type="button" className="link child-name" onClick={() => selectById(idOf(name) ?? "")}>
        {name}
      </button>
    ),
  }));
  return (
    <div className="form">
      <ElementHead id={id} kind="Barrier" owner={owner} />
      <Rows label="Leads to" one="target" items={items} onRemove={remove} onMove={move} />
      <FieldErrors id={id} field="to" />
      <div className="form-section">
        <ChoiceField label="Add" value="" place={`${id}/to`} choices={[{ value: "", text: "a state…" }, ...free.map((name) => ({ value: name, text: `→ ${name}` }))]} onChoose={add} />
      </div>
      <CommentSection id={id} />
    </div>
  );
}
