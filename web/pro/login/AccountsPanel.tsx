// The accounts of the server, over the page: opened from the account's menu, closed with Esc.
import { useEffect, useRef, useState, type SubmitEvent } from "react";
import { useModal } from "../../page/useModal";
import type { Account } from "../../generated/messages";
import { kRoles, kRoleTexts, type PersonRole } from "../../shared/login/roles";
import { useLogin } from "../client";
import { useAttempt } from "../documents/useAttempt";
import { addAccount, loadAccounts, removeAccount, setRole, showAccounts, useAccounts } from "./accounts";

export function AccountsPanel() {
  const shown = useAccounts((now) => now.shown);
  return shown ? <Panel /> : null;
}

const close = () => showAccounts(false);
const roleFrom = (text: string): PersonRole => kRoles.find((role) => role === text) ?? "observer";

function Panel() {
  const dialog = useModal();
  const { attempt, reason, busy } = useAttempt();
  const load = useRef(attempt);
  useEffect(() => {
    void load.current(loadAccounts);
  }, []);
  const accounts = useAccounts((now) => now.accounts);
  /** The row that had the focus is gone. */
  const focusFirst = () => dialog.current?.querySelector("input")?.focus();
  return (
    <dialog ref={dialog} className="documents accounts" aria-label="Accounts" onClose={close} onClick={(event) => event.target === event.currentTarget && close()} onKeyDown={(event) => event.stopPropagation()}>
      <div className="documents-body">
        <div className="documents-head">
          <h2>Accounts</h2>
          <button type="button" aria-label="Close" onClick={close}>
            ✕
          </button>
        </div>
        <NewAccount busy={busy} add={(name, role, password) => attempt(() => addAccount(name, role, password))} />
        {reason !== undefined && (
          <p className="bad" role="alert">
            {reason}
          </p>
        )}
        <ul className="document-list" aria-label="Accounts of this server">
          {accounts.map((account) => (
            <Row key={account.name} account={account} busy={busy} change={(role) => attempt(() => setRole(account.name, role))} remove={() => attempt(() => removeAccount(account.name)).then(focusFirst)} />
          ))}
        </ul>
        <dl className="role-list">
          {kRoles.map((role) => (
            <div key={role}>
              <dt>{role}</dt>
              <dd>{kRoleTexts[role]}</dd>
            </div>
          ))}
        </dl>
      </div>
    </dialog>
  );
}

interface NewProps {
  readonly busy: boolean;
  readonly add: (name: string, role: PersonRole, password: string) => Promise<void>;
}

function NewAccount({ busy, add }: NewProps) {
  const [name, setName] = useState("");
  const [password, setPassword] = useState("");
  const [role, setNewRole] = useState<PersonRole>("operator");
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    void add(name.trim(), role, password).then(() => {
      setName("");
      setPassword("");
    });
  };
  return (
    <form className="new-account" aria-label="New account" onSubmit={submit}>
      <input required placeholder="Name" aria-label="Name of the account" autoComplete="off" maxLength={40} pattern="[A-Za-z0-9][A-Za-z0-9_.\-]*" title="Letters, digits, _ - and ." value={name} onChange={(event) => setName(event.target.value)} />
      <input required type="password" placeholder="Password, at least 10 characters" aria-label="Password of the account" autoComplete="new-password" minLength={10} value={password} onChange={(event) => setPassword(event.target.value)} />
      <select aria-label="Role of the account" value={role} onChange={(event) => setNewRole(roleFrom(event.target.value))}>
        {kRoles.map((each) => (
          <option key={each}>{each}</option>
        ))}
      </select>
      <button type="submit" disabled={busy}>
        Add
      </button>
    </form>
  );
}

interface RowProps {
  readonly account: Account;
  readonly busy: boolean;
  readonly change: (role: PersonRole) => Promise<void>;
  readonly remove: () => Promise<void>;
}

function Row({ account, busy, change, remove }: RowProps) {
  const me = useLogin((login) => login.me?.name);
  const [asked, setAsked] = useState(false);
  const isMe = account.name === me;
  return (
    <li className="account-row" aria-label={account.name}>
      <strong>{account.name}</strong>
      {isMe && <small>you</small>}
      {account.role === "process" ? (
        <span className="quiet">process of services: {account.groups?.join(", ")}</span>
      ) : (
        <select aria-label={`Role of ${account.name}`} value={account.role} disabled={busy || isMe} onChange={(event) => void change(roleFrom(event.target.value))}>
          {kRoles.map((each) => (
            <option key={each}>{each}</option>
          ))}
        </select>
      )}
      {asked ? (
        <button type="button" className="is-danger" disabled={busy} onClick={() => void remove().then(() => setAsked(false))}>
          Remove {account.name} and all its tokens
        </button>
      ) : (
        <button type="button" disabled={busy || isMe} onClick={() => setAsked(true)}>
          Remove
        </button>
      )}
    </li>
  );
}
