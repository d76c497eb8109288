// Who uses the page, in the top bar: a menu with the way out, and for admins to the accounts.
import { useEffect, useRef, useState } from "react";
import { isReadOnly, refusalTo } from "../../shared/login/doings";
import { kRoles, kRoleTexts } from "../../shared/login/roles";
import { access, useLogin } from "../client";
import { showAccounts } from "./accounts";

export function AccountButton() {
  const me = useLogin((login) => login.me);
  const [open, setOpen] = useState(false);
  const menu = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (!open) return;
    const away = (event: Event) => event.target instanceof Node && menu.current?.contains(event.target) === false && setOpen(false);
    const escape = (event: KeyboardEvent) => event.key === "Escape" && setOpen(false);
    addEventListener("pointerdown", away);
    addEventListener("keydown", escape);
    return () => {
      removeEventListener("pointerdown", away);
      removeEventListener("keydown", escape);
    };
  }, [open]);
  if (me?.name === undefined) return null;
  const role = kRoles.find((each) => each === me.role);
  const means = role === undefined ? "" : `${role}: ${kRoleTexts[role]}`;
  const act = (what: () => void) => () => {
    setOpen(false);
    what();
  };
  return (
    <div className="account" ref={menu}>
      {isReadOnly(me) && (
        <span className="read-only" title={`Your account is an ${means}. An admin can give it another role.`}>
          Read only
        </span>
      )}
      <button type="button" aria-haspopup="menu" aria-expanded={open} title={`Logged in as ${me.name}, ${means}`} onClick={() => setOpen(!open)}>
        {me.name} <small>{me.role}</small>
      </button>
      {open && (
        <div role="menu" aria-label="Account">
          <p>{means}</p>
          {refusalTo(me, "manage_accounts") === undefined && (
            <button type="button" role="menuitem" onClick={act(() => showAccounts(true))}>
              Accounts…
            </button>
          )}
          <button type="button" role="menuitem" onClick={act(() => void access.logOut().catch(() => undefined))}>
            Log out
          </button>
        </div>
      )}
    </div>
  );
}
