// The name of an element. Another one is given to it also where it is named.
import { nameOfElement } from "../../../shared/edit/commands/command";
import { rename } from "../../../shared/edit/commands/setField";
import { useEditing } from "../editing";
import { TextField, type TextFieldProps } from "./TextField";
import type { ChangeOf } from "./useDraft";

const kName = /^[A-Za-z_]\w*$/;

/** `of`: what a valid name becomes. */
export const named =
  (of: (name: string) => ReturnType<ChangeOf>): ChangeOf =>
  (text) =>
    kName.test(text.trim()) ? of(text.trim()) : { reason: "a name has letters without accents, digits and _, and does not begin with a digit" };

type Props = Pick<TextFieldProps, "id" | "label" | "isBare" | "className">;

export function NameField(props: Props) {
  const { id } = props;
  const now = useEditing(({ session }) => (session?.view?.elements.has(id) === true ? nameOfElement(session.view, id) : ""));
  return <TextField {...props} field="name" now={now} change={named((name) => rename(id, name))} />;
}
