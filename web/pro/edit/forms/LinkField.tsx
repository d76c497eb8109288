// The state of the library that a state takes over (3.3.1).
import { nameOfElement } from "../../../shared/edit/commands/command";
import { setField } from "../../../shared/edit/commands/setField";
import type { State } from "../../../shared/model/model";
import { perform, useEditing } from "../editing";
import { ChoiceField } from "./ChoiceField";
import { FieldErrors } from "./FieldErrors";

export function LinkField({ state }: { readonly state: State }) {
  const { id = "", link = "" } = state;
  const tree = useEditing(({ session }) => session?.view);
  const names = tree?.library.filter((each) => each !== id).map((each) => nameOfElement(tree, each)) ?? [];
  if (names.length === 0 && link === "") return null;
  return (
    <>
      <ChoiceField label="Links" value={link} place={`${id}/link`} choices={[{ value: "", text: "nothing" }, ...names.map((name) => ({ value: name, text: name }))]} onChoose={(name) => perform(setField(id, "link", name === "" ? undefined : name))} />
      <FieldErrors id={id} field="link" />
    </>
  );
}
