// A field of an element that the format has as a text.
import { setField } from "../../../shared/edit/commands/setField";
import { entryOf } from "../../../shared/json";
import { useEditing } from "../editing";
import { TextField, type TextFieldProps } from "./TextField";

interface Props extends Omit<TextFieldProps, "now" | "change"> {
  /** An empty text stays one, in place of an absent field. */
  readonly isRequired?: boolean;
}

/** The text of a field of an element; empty, if it has none. */
export const useFieldText = (id: string, field: string): string =>
  useEditing(({ session }) => {
    const value = entryOf(session?.view?.elements.get(id)?.fields, field);
    return typeof value === "string" ? value : "";
  });

export function ElementText({ isRequired = false, ...props }: Props) {
  const { id, field } = props;
  return <TextField {...props} now={useFieldText(id, field)} change={(text) => setField(id, field, text === "" && !isRequired ? undefined : text)} />;
}
