// A field that is edited as a text: in one line, or in several. Enter commits one line, Ctrl+Enter several, leaving it either; Esc gives the draft up.
import { useId, type KeyboardEvent } from "react";
import { useRefusal } from "../../login/rights";
import { CodeInput, codeFieldOf } from "./CodeInput";
import { useRowEnter } from "./rowEnter";
import { FieldNotes } from "./FieldNotes";
import { useDraft, type ChangeOf, type DraftField } from "./useDraft";

export interface TextFieldProps {
  readonly id: string;
  readonly field: string;
  readonly label: string;
  /** What the document has; nothing: it is not known yet, and cannot be edited. */
  readonly now: string | undefined;
  readonly change: ChangeOf;
  /** `wrapped` and `expression`: one line, which is shown in several if it is long. */
  readonly kind?: "line" | "wrapped" | "expression" | "lines" | "code";
  /** The label is seen by nobody, only heard. */
  readonly isBare?: boolean;
  readonly placeholder?: string;
  /** Texts that are offered. */
  readonly choices?: readonly string[];
  readonly className?: string;
}

export function TextField({ id, field, label, now, change, kind = "line", isBare = false, placeholder, choices, className }: TextFieldProps) {
  const unique = useId();
  const draft = useDraft(id, field, now, change);
  const refusal = useRefusal("edit");
  const readOnly = now === undefined || refusal !== undefined;
  const control = {
    id: unique, "aria-label": isBare ? label : undefined, "aria-describedby": `${unique}-notes`, "data-place": `${id}/${field}`, placeholder, spellCheck: kind === "lines" || kind === "wrapped", readOnly, title: refusal,
    autoComplete: "off", value: draft.text, "aria-invalid": draft.reason !== undefined,
    onChange: (event: { readonly target: { readonly value: string } }) => draft.type(event.target.value),
    onBlur: () => draft.commit(false),
    onKeyDown: useFieldKeys(draft, kind !== "lines" && kind !== "code"),
  };
  const code = codeFieldOf(field);
  const classes = ["form-field", `is-${kind}`, draft.isDraft && "is-draft", isBare && "is-bare", className];
  return (
    <div className={classes.filter(Boolean).join(" ")}>
      {!isBare && (code === undefined ? <label htmlFor={unique}>{label}</label> : <span className="form-label">{label}</span>)}
      {code !== undefined ? (
        <CodeInput id={id} field={field} code={code} label={label} describedBy={`${unique}-notes`} draft={draft} placeholder={placeholder} multiline={kind === "code"} readOnly={readOnly} />
      ) : kind === "line" ? (
        <input type="text" {...control} list={choices && `${unique}-choices`} />
      ) : (
        <textarea {...control} rows={1} />
      )}
      {choices !== undefined && (
        <datalist id={`${unique}-choices`}>
          {choices.map((choice) => (
            <option key={choice} value={choice} />
          ))}
        </datalist>
      )}
      <FieldNotes id={id} field={field} noteId={`${unique}-notes`} draft={draft} />
    </div>
  );
}

function useFieldKeys(draft: DraftField, isOneLine: boolean) {
  const enter = useRowEnter();
  return (event: KeyboardEvent) => {
    if (event.nativeEvent.isComposing) return;
    if (event.key === "Escape" && draft.isDraft) {
      draft.giveUp();
      event.stopPropagation();
    } else if (event.key === "Enter" && (isOneLine ? !event.shiftKey : event.ctrlKey || event.metaKey)) {
      event.preventDefault();
      if (draft.isDraft) draft.commit(true);
      else if (isOneLine && !event.ctrlKey && !event.metaKey) enter?.();
    }
  };
}
