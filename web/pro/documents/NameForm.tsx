// Asks for the name of a document that does not exist yet.
import { useId, useState } from "react";
import { nameRefusal } from "../../shared/documents/names";

interface Props {
  readonly label: string;
  /** Of the button. */
  readonly does: string;
  readonly wish: string;
  readonly taken: ReadonlySet<string>;
  readonly disabled: boolean;
  /** It has been asked for alone, so what is typed next is the name. */
  readonly focus?: boolean;
  readonly onName: (name: string) => void;
  readonly onCancel?: () => void;
}

export function NameForm({ label, does, wish, taken, disabled, focus = false, onName, onCancel }: Props) {
  const [name, setName] = useState(wish);
  const reason = useId();
  const refusal = nameRefusal(name, taken);
  return (
    <form
      className="name-form"
      onSubmit={(event) => {
        event.preventDefault();
        if (refusal === undefined && !disabled) onName(name);
      }}
    >
      <label>
        <span>{label}</span>
        <input
          ref={focus ? selectAll : undefined}
          value={name}
          spellCheck={false}
          autoComplete="off"
          aria-invalid={name !== "" && refusal !== undefined}
          aria-describedby={reason}
          onChange={(event) => setName(event.target.value)}
          onKeyDown={(event) => {
            if (event.key !== "Escape" || onCancel === undefined) return;
            event.preventDefault();
            event.stopPropagation();
            onCancel();
          }}
        />
      </label>
      <button type="submit" disabled={disabled || refusal !== undefined}>
        {does}
      </button>
      {onCancel !== undefined && (
        <button type="button" onClick={onCancel}>
          Cancel
        </button>
      )}
      <small id={reason} role="status" className={name === "" || refusal === undefined ? "quiet" : "bad"}>
        {refusal}
      </small>
    </form>
  );
}

function selectAll(input: HTMLInputElement | null): void {
  input?.focus();
  input?.select();
}
