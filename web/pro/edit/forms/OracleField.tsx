// The dynamic oracle of a composite (3.3.2): what decides which child is entered first.
import { setField } from "../../../shared/edit/commands/setField";
import { entryOf, isObject, type JsonObject } from "../../../shared/json";
import type { State } from "../../../shared/model/model";
import { perform, useEditing } from "../editing";
import { CheckField } from "./CheckField";
import { ChoiceField } from "./ChoiceField";
import { FieldErrors } from "./FieldErrors";
import { PortChecks } from "./PortChecks";
import { TextField } from "./TextField";

const kNone: JsonObject = {};

const kKinds = [
  { value: "", text: "always there" },
  { value: "expr", text: "by an expression" },
  { value: "external", text: "by a service" },
  { value: "history", text: "where it was left" },
];

/** An oracle of another kind begins with nothing. */
const begun = (kind: string): Readonly<Record<string, string>> | undefined =>
  kind === "" ? undefined : kind === "expr" ? { kind, expr: "" } : kind === "external" ? { kind, call: "svc.Oracle.decide(par, res, var)" } : { kind };

const textIn = (oracle: JsonObject, field: string): string => {
  const value = entryOf(oracle, field);
  return typeof value === "string" ? value : "";
};

export function OracleField({ state }: { readonly state: State }) {
  const { id = "" } = state;
  const oracle = useEditing(({ session }) => {
    const value = entryOf(session?.view?.elements.get(id)?.fields, "oracle");
    return isObject(value) ? value : kNone;
  });
  const kind = textIn(oracle, "kind");
  return (
    <>
      <ChoiceField label="Chosen" value={kind} place={`${id}/oracle`} choices={kKinds} onChoose={(chosen) => perform(setField(id, "oracle", begun(chosen)))} />
      {kind === "expr" && (
        <TextField id={id} field="oracle:expr" label="Name of the child" kind="expression" now={textIn(oracle, "expr")} placeholder="'A' if par.x else 'B'" change={(expr) => setField(id, "oracle", { kind, expr })} />
      )}
      {kind === "external" && <TextField id={id} field="oracle:call" label="Call that answers it" kind="expression" now={textIn(oracle, "call")} change={(call) => setField(id, "oracle", { kind, call })} />}
      {kind === "history" && <History state={state} oracle={oracle} />}
      <FieldErrors id={id} field="oracle" />
    </>
  );
}

function History({ state, oracle }: { readonly state: State; readonly oracle: JsonObject }) {
  const { id = "" } = state;
  const deep = entryOf(oracle, "deep") === true;
  const names = entryOf(oracle, "resume");
  const resume = Array.isArray(names) ? names.filter((name) => typeof name === "string") : undefined;
  const put = (ports: readonly string[] | undefined, isDeep: boolean) => perform(setField(id, "oracle", { kind: "history", ...(ports !== undefined && { resume: ports }), ...(isDeep && { deep: true }) }));
  return (
    <>
      <CheckField label="Also inside of it (deep)" checked={deep} onChange={(checked) => put(resume, checked)} />
      <PortChecks label="Goes on after it was left through" state={state} names={resume} onChange={(ports) => put(ports, deep)} />
    </>
  );
}
