// The login of a display: large, for a phone.
import { useState, type SubmitEvent } from "react";
import { messageOf } from "../shared/messageOf";
import { PairingNotice } from "./PairingNotice";
import { StoppedBanner } from "../stop/StoppedBanner";
import { trustAddress } from "../shared/trust/trustAddress";
import { texts } from "./texts";

interface Props {
  /** Throws what is in the way. */
  readonly logIn: (name: string, password: string) => Promise<void>;
}

export function Login({ logIn }: Props) {
  const [name, setName] = useState("");
  const [password, setPassword] = useState("");
  const [reason, setReason] = useState<string>();
  const [busy, setBusy] = useState(false);
  const trust = trustAddress(location);
  const enter = async (event: SubmitEvent) => {
    event.preventDefault();
    setBusy(true);
    setReason(undefined);
    try {
      await logIn(name.trim(), password);
    } catch (error) {
      setReason(messageOf(error));
      setBusy(false);
    }
  };
  return (
    <main>
      <StoppedBanner refusal={texts.login.first} fetcher={fetch} />
      <form className="display login" aria-label={texts.login.form} onSubmit={(event) => void enter(event)}>
        <h1>{texts.login.title}</h1>
        <PairingNotice />
        <input aria-label={texts.login.name} placeholder={texts.login.name} autoComplete="username" autoCapitalize="none" spellCheck={false} maxLength={40} value={name} onChange={(event) => setName(event.target.value)} />
        <input aria-label={texts.login.password} placeholder={texts.login.password} type="password" autoComplete="current-password" value={password} onChange={(event) => setPassword(event.target.value)} />
        {reason !== undefined && (
          <p className="notice is-bad" role="alert">
            {reason}
          </p>
        )}
        <button type="submit" className="choice" disabled={busy || name.trim() === "" || password === ""}>
          {texts.login.enter}
        </button>
        {trust !== undefined && (
          <p className="hint">
            {texts.login.warned} <a href={trust}>{texts.login.trust}</a>
          </p>
        )}
      </form>
    </main>
  );
}
