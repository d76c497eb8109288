// What the server finds wrong with a field that has no draft, or with an element as a whole (an empty `field`).
import { useFieldErrors } from "./useFieldErrors";

export function FieldErrors({ id, field }: { readonly id: string; readonly field: string }) {
  const errors = useFieldErrors(id, field);
  if (errors.length === 0) return null;
  return (
    <div className="field-notes">
      {errors.map(({ message }, i) => (
        <p key={i} className="field-error">
          {message}
        </p>
      ))}
    </div>
  );
}
