// What the phone shall be: its name and place, and what it may.
import type { ReactNode } from "react";
import type { PairingCreate } from "../generated/messages";
import { kRoleTexts } from "../shared/login/roles";
import { texts } from "./texts";

const t = texts.fields;
const kRoles = ["operator", "observer"] as const;

interface Props {
  /** Without a role, the server asks nobody who they are. */
  readonly values: { readonly name: string; readonly place: string; readonly role: PairingCreate["role"] | undefined };
  readonly isName: boolean;
  readonly isPlace: boolean;
  readonly onName: (name: string) => void;
  readonly onPlace: (place: string) => void;
  readonly onRole: (role: PairingCreate["role"]) => void;
  /** Which network the phone is in. */
  readonly children: ReactNode;
}

export function PairingFields({ values: { name, place, role }, isName, isPlace, onName, onPlace, onRole, children }: Props) {
  return (
    <>
      <div className="pairing-fields">
        <label>
          {t.name} <input type="text" value={name} aria-invalid={!isName} aria-describedby={isName ? undefined : "pairing-name"} spellCheck={false} autoComplete="off" onChange={(event) => onName(event.target.value)} />
        </label>
        <label>
          {t.place} <input type="text" value={place} placeholder={t.placeHint} aria-invalid={!isPlace} aria-describedby={isPlace ? undefined : "pairing-name"} spellCheck={false} autoComplete="off" onChange={(event) => onPlace(event.target.value)} />
        </label>
        {role !== undefined && (
          <label>
            {t.role}{" "}
            <select value={role} onChange={(event) => onRole(event.target.value === "observer" ? "observer" : "operator")}>
              {kRoles.map((each) => (
                <option key={each} value={each}>
                  {t.roleIs(each, kRoleTexts[each])}
                </option>
              ))}
            </select>
          </label>
        )}
        {children}
      </div>
      {!(isName && isPlace) && (
        <p id="pairing-name" className="bad" role="alert">
          {t.wrongName}
        </p>
      )}
    </>
  );
}
