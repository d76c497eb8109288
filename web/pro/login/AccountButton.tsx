// Who uses the page, in the top bar: a menu with the way out, and for admins to the accounts.
import { useEffect, useRef, useState } from "react";
import { mayUse } from "../../shared/login/roles";
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
  const act = (what: () => void) => () => {
    setOpen(false);
    what();
  };
  return (
    <div className="account" ref={menu}>
      <button type="button" aria-haspopup="menu" aria-expanded={open} title={`Logged in as ${me.name}, ${me.role ?? ""}`} onClick={() => setOpen(!open)}>
        {me.name} <small>{me.role}</small>
      </button>
      {open && (
        <div role="menu" aria-label="Account">
          {mayUse(me.role, "admin") && (
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
