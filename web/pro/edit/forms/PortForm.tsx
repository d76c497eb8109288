// A selected port.
import { kOfPort } from "../../../shared/debugger/places";
import { BreakpointChoices } from "../../debugger/BreakpointChoices";
import { ConditionField, TargetField } from "./PortFields";
import { ElementHead } from "./ElementHead";
import { useOwner } from "./useOwner";

export function PortForm({ id }: { readonly id: string }) {
  return (
    <div className="form">
      <ElementHead id={id} kind="Port" owner={useOwner(id)} />
      <div className="form-section">
        <ConditionField id={id} />
        <TargetField id={id} />
      </div>
      <BreakpointChoices kinds={kOfPort} />
    </div>
  );
}
