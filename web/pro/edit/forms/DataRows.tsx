// Parameters, results and variables of a state. A linking state takes over the results and variables of the library.
import { useState, type ReactNode } from "react";
import { readExact, type ExactJson } from "../../../shared/edit/exact";
import { setOperation } from "../../../shared/edit/commands/setField";
import { entryOf } from "../../../shared/json";
import type { State } from "../../../shared/model/model";
import { ParameterNow, ValueNow } from "../../live/ValueNow";
import { WhyLink } from "../../live/WhyLink";
import { useRefusal } from "../../login/rights";
import { perform, useEditing } from "../editing";
import { ElementRows } from "./ElementRows";
import { ElementText } from "./ElementText";
import { ConstantField, TypeField } from "./JsonField";
import { NameField } from "./NameField";
import { useExactText } from "./useExactText";
import { useHas } from "./useHas";

export function DataRows({ state }: { readonly state: State }) {
  const { id = "", link, results, variables } = state;
  return (
    <>
      <ElementRows state={id} list="parameters" label="Parameters" one="parameter" row={(each) => <ParameterRow id={each} />} />
      {(link === undefined || results.length > 0) && <ElementRows state={id} list="results" label="Results" one="result" row={(each) => <DeclarationRow id={each} />} />}
      {(link === undefined || variables.length > 0) && <ElementRows state={id} list="variables" label="Variables" one="variable" row={(each) => <DeclarationRow id={each} />} />}
    </>
  );
}

function ParameterRow({ id }: { readonly id: string }) {
  const [hasValue, hasFrom] = [useHas(id, "value"), useHas(id, "from")];
  const [wish, setWish] = useState<"value" | "from">("value");
  const refusal = useRefusal("edit");
  const exact = useExactText(id, "value");
  const from = useEditing(({ session }) => entryOf(session?.view?.elements.get(id)?.fields, "from"));
  const kind = hasFrom ? "from" : hasValue ? "value" : wish;
  const exchange = () => {
    setWish(kind === "value" ? "from" : "value");
    if (hasValue && exact !== undefined) perform({ operations: [setOperation(id, "value", undefined), setOperation(id, "from", expressionOf(exact))] });
    if (hasFrom && typeof from === "string") perform({ operations: [setOperation(id, "from", undefined), setOperation(id, "value", constantOf(from))] });
  };
  return (
    <Datum
      id={id}
      now={
        <>
          <ParameterNow id={id} />
          <WhyLink id={id} name="this parameter" />
        </>
      }
    >
      <button
        type="button"
        className="row-kind"
        disabled={refusal !== undefined}
        title={refusal ?? (kind === "value" ? "A constant; click for an expression of the parent" : "An expression of the parent; click for a constant")}
        aria-label={kind === "value" ? "Constant: make it an expression" : "Expression: make it a constant"}
        onClick={exchange}
      >
        {kind === "value" ? "=" : "←"}
      </button>
      {kind === "value" ? (
        <ConstantField id={id} field="value" label="Constant" isBare placeholder="required" className="row-value" />
      ) : (
        <ElementText id={id} field="from" label="Expression of the parent" kind="expression" isBare placeholder="par.x" className="row-value" />
      )}
    </Datum>
  );
}

/** A constant as the function language writes it. */
const expressionOf = (exact: string): string => exact.replace(/"(?:[^"\\]|\\.)*"|\b(?:true|false|null)\b/g, (token) => ({ true: "True", false: "False", null: "None" })[token] ?? token);

/** An expression that is a constant; null for any other one. */
function constantOf(expression: string): ExactJson {
  try {
    return readExact(expression.replace(/"(?:[^"\\]|\\.)*"|\b(?:True|False|None)\b/g, (token) => ({ True: "true", False: "false", None: "null" })[token] ?? token));
  } catch {
    return null;
  }
}

function DeclarationRow({ id }: { readonly id: string }) {
  return (
    <Datum id={id} now={<ValueNow id={id} />}>
      <span className="row-kind" aria-hidden="true">
        =
      </span>
      <ConstantField id={id} field="initial" label="Initial value" isBare placeholder="no value yet" className="row-value" />
    </Datum>
  );
}

interface DatumProps {
  readonly id: string;
  /** Its value in the run. */
  readonly now: ReactNode;
  readonly children: ReactNode;
}

/** Name and value in one line; below, what is said of type, unit and description, or all three for whoever wants to write them. */
function Datum({ id, now, children }: DatumProps) {
  const isFull = ![useHas(id, "type"), useHas(id, "unit"), useHas(id, "doc")].includes(false);
  const [isOpen, setOpen] = useState(false);
  return (
    <div className="datum">
      <NameField id={id} label="Name" isBare className="row-name" />
      <div className="datum-value">{children}</div>
      {!isFull && (
        <button type="button" className="row-more" aria-expanded={isOpen} aria-label="Type, unit and description" title="Type, unit and description" onClick={() => setOpen(!isOpen)}>
          …
        </button>
      )}
      {now}
      <div className={isOpen ? "row-about is-open" : "row-about"}>
        <TypeField id={id} isBare />
        <ElementText id={id} field="unit" label="Unit" isBare placeholder="unit" className="row-unit" />
        <ElementText id={id} field="doc" label="Description" kind="wrapped" isBare placeholder="description" className="row-doc" />
      </div>
    </div>
  );
}
