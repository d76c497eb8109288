// Whether a state keeps its values when it is left (R8, R26).
import { setField } from "../../../shared/edit/commands/setField";
import { entryOf, isObject, type JsonValue } from "../../../shared/json";
import type { State } from "../../../shared/model/model";
import { perform, useEditing } from "../editing";
import { ChoiceField } from "./ChoiceField";
import { FieldErrors } from "./FieldErrors";
import { PortChecks } from "./PortChecks";

const kChoices = [
  { value: "", text: "begin anew" },
  { value: "keep", text: "stay, while its parent is active" },
  { value: "deep", text: "stay, also with its parent" },
];

/** The ports that are named; nothing: any. */
function portsOf(keep: JsonValue | undefined): readonly string[] | undefined {
  const names = isObject(keep) ? entryOf(keep, "ports") : keep;
  return Array.isArray(names) ? names.filter((name) => typeof name === "string") : undefined;
}

const keepOf = (kind: string, ports: readonly string[] | undefined) => (kind === "" ? undefined : kind === "keep" ? (ports ?? true) : { deep: true as const, ...(ports !== undefined && { ports }) });

export function KeepField({ state }: { readonly state: State }) {
  const { id = "" } = state;
  const keep = useEditing(({ session }) => entryOf(session?.view?.elements.get(id)?.fields, "keep"));
  const kind = keep === undefined ? "" : isObject(keep) ? "deep" : "keep";
  const ports = portsOf(keep);
  const put = (next: string, names: readonly string[] | undefined) => perform(setField(id, "keep", keepOf(next, names)));
  return (
    <>
      <ChoiceField label="Its values" value={kind} place={`${id}/keep`} choices={kChoices} onChoose={(chosen) => put(chosen, ports)} />
      {kind !== "" && <PortChecks label="Stay after it was left through" state={state} names={ports} onChange={(names) => put(kind, names)} />}
      <FieldErrors id={id} field="keep" />
    </>
  );
}
