// A text: taken when the field is left, or by Enter.
import { useId, useState } from "react";
import type { ExactJson } from "../../shared/edit/exact";
import { kMostText } from "../../shared/skills/form";

interface Props {
  readonly id: string;
  readonly label: string;
  readonly disabled: boolean;
  readonly value: string;
  readonly set: (value: ExactJson) => void;
  readonly isLong: boolean;
  /** Texts that are offered. */
  readonly known?: readonly string[];
}

export function TextField({ id, disabled, value, set, isLong, known }: Props) {
  const list = useId();
  const [draft, setDraft] = useState<string>();
  const commit = () => {
    if (draft !== undefined && draft !== value) set(draft);
    setDraft(undefined);
  };
  const common = { id, disabled, value: draft ?? value, maxLength: kMostText, onBlur: commit };
  if (isLong) return <textarea {...common} rows={2} onChange={(event) => setDraft(event.target.value)} />;
  return (
    <>
      <input {...common} autoComplete="off" {...(known !== undefined && { list })} onChange={(event) => setDraft(event.target.value)} onKeyDown={(event) => event.key === "Enter" && commit()} />
      {known !== undefined && (
        <datalist id={list}>
          {known.map((text) => (
            <option key={text} value={text} />
          ))}
        </datalist>
      )}
    </>
  );
}
