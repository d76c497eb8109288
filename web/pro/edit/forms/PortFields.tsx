// What a port has: its name, its condition or time-out, and the sibling that it leads to.
import { elementOf, listOf } from "../../../shared/edit/tree";
import { nameOfElement } from "../../../shared/edit/commands/command";
import { portConflicts } from "../../../shared/edit/order";
import { setOperation } from "../../../shared/edit/commands/setField";
import { entryOf } from "../../../shared/json";
import type { State } from "../../../shared/model/model";
import { ConditionNow } from "../../live/ConditionNow";
import { WhyLink } from "../../live/WhyLink";
import { useRefusal } from "../../login/rights";
import { perform, useEditing } from "../editing";
import { ChoiceField } from "./ChoiceField";
import { ElementRows } from "./ElementRows";
import { ElementText, useFieldText } from "./ElementText";
import { NameField } from "./NameField";
import { FieldErrors } from "./FieldErrors";
import { useHas } from "./useHas";

export function PortRows({ state }: { readonly state: State }) {
  const conflicts = portConflicts(state.ports, state.link !== undefined);
  return <ElementRows state={state.id ?? ""} list="ports" label={conflicts.size > 0 ? "Ports, in order of evaluation" : "Ports"} one="port" numbered={conflicts} row={(id) => <PortRow id={id} />} />;
}

function PortRow({ id }: { readonly id: string }) {
  return (
    <div className="port-row">
      <NameField id={id} label="Name" isBare className="row-name" />
      <TargetField id={id} isBare />
      <ConditionField id={id} />
    </div>
  );
}

/** Whether the state of the port takes the library's conditions over. */
const useIsLinked = (id: string): boolean =>
  useEditing(({ session }) => {
    const port = session?.view?.elements.get(id);
    return entryOf(session?.view?.elements.get(port?.parent ?? "")?.fields, "link") !== undefined;
  });

/** The condition, or the time-out. The other one begins as what changes the least: a port that does not fire soon. */
export function ConditionField({ id }: { readonly id: string }) {
  const [hasWhen, isTimed, isLinked] = [useHas(id, "when"), useHas(id, "after"), useIsLinked(id)];
  const refusal = useRefusal("edit");
  if (isLinked && !hasWhen && !isTimed) return <small className="field-hint">The condition is the library&apos;s.</small>;
  const exchange = () =>
    perform({ operations: isTimed ? [setOperation(id, "after", undefined), setOperation(id, "when", "False")] : [setOperation(id, "when", undefined), setOperation(id, "after", "10.0")] });
  return (
    <div className="condition">
      <button type="button" className="row-kind" aria-label={isTimed ? "Time-out: make it a condition" : "Condition: make it a time-out"} disabled={refusal !== undefined} title={refusal ?? (isTimed ? "Fires this long after the activation of its state [s]; click for a condition" : "Fires when this holds; click for a time-out")} onClick={exchange}>
        {isTimed ? "after" : "when"}
      </button>
      {isTimed ? (
        <ElementText id={id} field="after" label="Time-out in seconds" kind="expression" isBare isRequired placeholder="seconds" className="row-value" />
      ) : (
        <ElementText id={id} field="when" label="Condition" kind="expression" isBare isRequired placeholder="condition" className="row-value" />
      )}
      <ConditionNow id={id} />
      <WhyLink id={id} name="this port" />
    </div>
  );
}

/** The sibling that a port leads to. The ports of the root lead nowhere. */
export function TargetField({ id, isBare = false }: { readonly id: string; readonly isBare?: boolean }) {
  const tree = useEditing(({ session }) => session?.view);
  const to = useFieldText(id, "to");
  const port = tree?.elements.get(id);
  if (tree === undefined || port === undefined) return null;
  const { parent, list } = elementOf(tree, port.parent);
  if (list !== "children" && to === "") return null;
  const siblings = list === "children" ? listOf(tree, parent, "children") : [];
  const names = siblings.map((each) => ({ each, name: nameOfElement(tree, each) }));
  const lead = (name: string) => {
    const target = names.find((sibling) => sibling.name === name)?.each;
    perform({ compound: { kind: "connect", from: id, ...(target !== undefined && { to: target }) } });
  };
  return (
    <div className="target">
      <ChoiceField label="Leads to" isBare={isBare} value={to} place={`${id}/to`} onChoose={lead} choices={[{ value: "", text: "exits" }, ...names.map(({ name }) => ({ value: name, text: `→ ${name}` }))]} />
      <FieldErrors id={id} field="to" />
    </div>
  );
}
