// What an element is, where it is, its name, and what is wrong with it as a whole.
import type { ReactNode } from "react";
import { FieldErrors } from "./FieldErrors";
import { NameField } from "./NameField";
import { selectById } from "./selectById";

interface Props {
  readonly id: string;
  readonly kind: string;
  /** The element that it belongs to. */
  readonly owner?: { readonly id: string; readonly name: string } | undefined;
  readonly children?: ReactNode;
}

export function ElementHead({ id, kind, owner, children }: Props) {
  return (
    <header className="form-head">
      <small>
        {kind}
        {owner !== undefined && (
          <>
            {" in "}
            <button type="button" className="link" onClick={() => selectById(owner.id)}>
              {owner.name}
            </button>
          </>
        )}
        {children}
      </small>
      <NameField id={id} label="Name" isBare className="form-title" />
      <FieldErrors id={id} field="" />
    </header>
  );
}
