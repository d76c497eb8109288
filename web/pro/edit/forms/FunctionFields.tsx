// The functions of a state: entry, actions in their order, exit.
import { actionConflicts } from "../../../shared/edit/order";
import type { State } from "../../../shared/model/model";
import { ActionBreakpoint } from "../../debugger/BreakpointChoices";
import { WhyLink } from "../../live/WhyLink";
import { ElementRows } from "./ElementRows";
import { ElementText } from "./ElementText";

export function FunctionFields({ state }: { readonly state: State }) {
  const id = state.id ?? "";
  const conflicts = actionConflicts(state.actions);
  return (
    <section className="form-section functions" aria-label="Functions">
      <ElementText id={id} field="entry" label="Entry" kind="code" placeholder="runs when the state is entered" />
      <ElementRows state={id} list="actions" label={conflicts.size > 0 ? "Actions, in order of evaluation" : "Actions"} one="action" numbered={conflicts} row={(action) => <ActionRow id={action} />} />
      <ElementText id={id} field="exit" label="Exit" kind="code" placeholder="runs when the state is left" />
    </section>
  );
}

function ActionRow({ id }: { readonly id: string }) {
  return (
    <>
      <ActionBreakpoint id={id} />
      <WhyLink id={id} name="this action" />
      <ElementText id={id} field="when" label="Condition" kind="expression" isBare isRequired placeholder="condition" className="row-when" />
      <ElementText id={id} field="do" label="Function" kind="code" isBare isRequired placeholder="function" />
    </>
  );
}
