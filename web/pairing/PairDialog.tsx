// How a phone becomes a display and teach pendant: its name and place, what it may, and a code that it scans.
import { useState } from "react";
import type { Me, PairingCreate } from "../generated/messages";
import type { Api } from "../shared/api";
import { useModal } from "../page/useModal";
import { isDisplayName, networkChoice, pairing } from "../shared/display/pairing";
import { useCode } from "./code";
import { CodeNotice } from "./CodeNotice";
import { NetworkChoice } from "./NetworkChoice";
import { Details } from "./Details";
import { PairCode } from "./PairCode";
import { PairingFields } from "./PairingFields";
import { Steps } from "./Steps";
import { texts } from "./texts";

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
    <dialog ref={dialog} className="pairing" aria-label={texts.title} onClose={onClose} onClick={(event) => event.target === event.currentTarget && close()} onKeyDown={(event) => event.stopPropagation()}>
      <div className="pairing-body">
        <div className="pairing-head">
          <h2>{texts.title}</h2>
          <button type="button" aria-label={texts.close} onClick={close}>
            ✕
          </button>
        </div>
        <p>{texts.about}</p>
        <PairingFields values={{ name, place, role: hasAccounts ? role : undefined }} isName={isName} isPlace={isPlace} onName={setName} onPlace={setPlace} onRole={setRole}>
          <NetworkChoice networks={networkChoice(location, origins)} chosen={network} onChoose={setChosen} />
        </PairingFields>
        {/* Until the code is there, it is not known. */}
        <Steps isReached={tunnel === undefined || code.kind === "asked"} hasCode={code.kind !== "none"} />
        {hasAccounts && refusal !== undefined && <p>{texts.code.refused(refusal)}</p>}
        {isName && isPlace && (code.kind === "none" || code.kind === "there") && <PairCode address={address} until={code.kind === "there" ? code.until : undefined} />}
        <CodeNotice code={code} onRenew={() => setAttempt(attempt + 1)} />
        <Details tunnel={tunnel} trust={trust} />
      </div>
    </dialog>
  );
}
