// What the server finds wrong with a field that has no draft, or with an element as a whole (an empty `field`), and what somebody else has set there.
import { ConflictNote } from "../ConflictChoices";
import { useConflictAt } from "../conflicts";
import { useFieldErrors } from "./useFieldErrors";

export function FieldErrors({ id, field }: { readonly id: string; readonly field: string }) {
  const errors = useFieldErrors(id, field);
  const conflict = useConflictAt(id, field);
  if (errors.length === 0 && conflict === undefined) return null;
  return (
    <div className="field-notes">
      <ConflictNote id={id} field={field} />
      {errors.map(({ message }, i) => (
        <p key={i} className="field-error">
          {message}
        </p>
      ))}
    </div>
  );
}
