// A constant or a type as a text, with the numbers as they are written.
import { readExact, type Exact } from "../../../shared/edit/exact";
import { setField } from "../../../shared/edit/commands/setField";
import { TextField, type TextFieldProps } from "./TextField";
import { useExactText } from "./useExactText";
import type { ChangeOf } from "./useDraft";

type Props = Omit<TextFieldProps, "now" | "change" | "kind">;

const readable = (text: string): Exact<unknown> | undefined => {
  try {
    return readExact(text);
  } catch {
    return undefined;
  }
};

/** A constant; an empty text: none. */
const constantOf =
  (id: string, field: string): ChangeOf =>
  (text) => {
    if (text.trim() === "") return setField(id, field, undefined);
    const value = readable(text);
    return value === undefined ? { reason: 'no constant of JSON, such as 0.5, true, "text" in double quotes, [1.0, 2.0] or {"x": 1.0}' } : setField(id, field, value);
  };

export function ConstantField(props: Props) {
  return <TextField {...props} kind="expression" now={useExactText(props.id, props.field)} change={constantOf(props.id, props.field)} />;
}

const kPlainTypes: readonly string[] = ["any", "null", "bool", "int", "number", "string", "pose", "image"];

/** Plain types are words, others JSON. */
const typeOf =
  (id: string): ChangeOf =>
  (text) => {
    const word = text.trim();
    if (word === "") return setField(id, "type", undefined);
    if (kPlainTypes.includes(word)) return setField(id, "type", word);
    const value = readable(word);
    return value === undefined ? { reason: `no type: ${kPlainTypes.join(", ")}, or JSON such as {"list": "number", "size": 3}` } : setField(id, "type", value);
  };

export function TypeField({ id, isBare }: Pick<Props, "id" | "isBare">) {
  const exact = useExactText(id, "type");
  const word = kPlainTypes.find((plain) => exact === JSON.stringify(plain));
  return <TextField id={id} field="type" label="Type" placeholder="type" isBare={isBare === true} now={word ?? exact} change={typeOf(id)} choices={kPlainTypes} />;
}
