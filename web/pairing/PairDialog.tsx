// How a phone becomes a display and teach pendant: its name and place, what it may, and a code that it scans.
import { useState } from "react";
import type { Me, PairingCreate } from "../generated/messages";
import type { Api } from "../shared/api";
import { useModal } from "../page/useModal";
import { isDisplayName, networkChoice, pairing } from "../shared/display/pairing";
import { kRoleTexts } from "../shared/login/roles";
import { useCode } from "./code";
import { NetworkChoice } from "./NetworkChoice";
import { PairCode } from "./PairCode";
import { Reach } from "./Reach";

interface Props {
  readonly api: Api;
  /** Who uses the page. */
  readonly me: Me | undefined;
  /** Why this person lets no phone in. */
  readonly refusal: string | undefined;
  readonly onClose: () => void;
}

/** As in the README; a task shows most things on all displays. */
const kDefaultName = "phone1";
const kDays = 30;
const kRoles = ["operator", "observer"] as const;

export function PairDialog({ api, me, refusal, onClose }: Props) {
  const dialog = useModal();
  const close = () => dialog.current?.close();
  const [name, setName] = useState(kDefaultName);
  const [place, setPlace] = useState("");
  const [role, setRole] = useState<PairingCreate["role"]>("operator");
  const [chosen, setChosen] = useState<string>();
  const [attempt, setAttempt] = useState(0);
  const isName = isDisplayName(name);
  const isPlace = place === "" || isDisplayName(place);
  const shown = { name: isName ? name : kDefaultName, ...(isPlace && place !== "" && { place }) };
  const hasAccounts = me?.accounts === true;
  const code = useCode(api, hasAccounts && refusal === undefined && isName && isPlace ? { role, ...shown, days: kDays } : undefined, attempt);
  const origins = code.kind === "there" ? code.origins : [];
  // One that was chosen before, unless the server is there no more.
  const network = origins.find((each) => each === chosen) ?? origins[0];
  const { address, trust, tunnel } = pairing(location, { ...shown, ...(code.kind === "there" && { code: code.code }) }, network);
  return (
    <dialog ref={dialog} className="pairing" aria-label="Pair a phone" onClose={onClose} onClick={(event) => event.target === event.currentTarget && close()} onKeyDown={(event) => event.stopPropagation()}>
      <div className="pairing-body">
        <div className="pairing-head">
          <h2>Pair a phone</h2>
          <button type="button" aria-label="Close" onClick={close}>
            ✕
          </button>
        </div>
        <p>The phone becomes a display, where tasks show messages and ask questions, and a teach pendant, by which the robot is moved by hand and tasks are started.</p>
        <div className="pairing-fields">
          <label>
            Name of the display <input type="text" value={name} aria-invalid={!isName} aria-describedby={isName ? undefined : "pairing-name"} spellCheck={false} autoComplete="off" onChange={(event) => setName(event.target.value)} />
          </label>
          <label>
            Its place <input type="text" value={place} placeholder="gripper" aria-invalid={!isPlace} aria-describedby={isPlace ? undefined : "pairing-name"} spellCheck={false} autoComplete="off" onChange={(event) => setPlace(event.target.value)} />
          </label>
          {hasAccounts && (
            <label>
              What it may{" "}
              <select value={role} onChange={(event) => setRole(event.target.value === "observer" ? "observer" : "operator")}>
                {kRoles.map((each) => (
                  <option key={each} value={each}>
                    {each}: {kRoleTexts[each]}
                  </option>
                ))}
              </select>
            </label>
          )}
          <NetworkChoice networks={networkChoice(location, origins)} chosen={network} onChoose={setChosen} />
        </div>
        {!(isName && isPlace) && (
          <p id="pairing-name" className="bad" role="alert">
            A name has 1 to 32 of A-Z, a-z, 0-9, _ and -, and is not all.
          </p>
        )}
        {tunnel !== undefined && <Reach tunnel={tunnel} />}
        {trust !== undefined && (
          <p>
            The phone warns of this server until it trusts it, which it learns once at <a href={trust}>{trust}</a>.
          </p>
        )}
        {hasAccounts && refusal !== undefined && <p>You let no phone in: {refusal}. It can log in at this address.</p>}
        {code.kind === "asked" && <p className="quiet">Asking the server for a code…</p>}
        {(code.kind === "failed" || code.kind === "over") && (
          <p role="alert">
            {code.kind === "over" ? "The code is good no more. " : `There is no code: ${code.why}. `}
            <button type="button" onClick={() => setAttempt(attempt + 1)}>
              New code
            </button>
          </p>
        )}
        {isName && isPlace && (code.kind === "none" || code.kind === "there") && <PairCode address={address} until={code.kind === "there" ? code.until : undefined} />}
      </div>
    </dialog>
  );
}
