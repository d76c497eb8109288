// The login, over the page: what was edited and looked at stays below it, and goes on when somebody has logged in.
import { useEffect, useRef, useState, type SubmitEvent } from "react";
import { isRefusal } from "../../shared/api";
import { messageOf } from "../../shared/messageOf";
import { trustAddress } from "../../shared/trust/trustAddress";
import { logIn, useLogin } from "../client";

export function LoginCover() {
  const asked = useLogin((login) => login.asked);
  return asked ? <Login /> : null;
}

const reasonOf = (error: unknown): string => (isRefusal(error) && error.retryAfter !== undefined ? `Too many logins have failed. Try again in ${error.retryAfter} s.` : messageOf(error));

function Login() {
  const dialog = useRef<HTMLDialogElement>(null);
  const [name, setName] = useState("");
  const [password, setPassword] = useState("");
  const [reason, setReason] = useState<string>();
  const [busy, setBusy] = useState(false);
  const trust = trustAddress(location);
  useEffect(() => dialog.current?.showModal(), []);

  const enter = async (event: SubmitEvent) => {
    event.preventDefault();
    setBusy(true);
    setReason(undefined);
    try {
      await logIn(name.trim(), password);
    } catch (error) {
      setReason(reasonOf(error));
      setPassword("");
    } finally {
      setBusy(false);
    }
  };

  return (
    <dialog ref={dialog} className="login" aria-labelledby="login-title" onCancel={(event) => event.preventDefault()} onKeyDown={(event) => event.stopPropagation()}>
      <form onSubmit={(event) => void enter(event)}>
        <h2 id="login-title">Log in to RACE</h2>
        <label>
          <span>Name</span>
          <input autoComplete="username" autoCapitalize="none" spellCheck={false} required maxLength={40} value={name} onChange={(event) => setName(event.target.value)} />
        </label>
        <label>
          <span>Password</span>
          <input type="password" autoComplete="current-password" required value={password} onChange={(event) => setPassword(event.target.value)} />
        </label>
        {reason !== undefined && (
          <p className="bad" role="alert">
            {reason}
          </p>
        )}
        <button type="submit" className="is-main" disabled={busy || name.trim() === "" || password === ""}>
          {busy ? "Checking…" : "Log in"}
        </button>
        <p className="quiet">Accounts are made by an admin of this server.</p>
        {trust !== undefined && (
          <p className="quiet">
            Did the browser warn of this server? <a href={trust}>Let this device trust it</a>
          </p>
        )}
      </form>
    </dialog>
  );
}
