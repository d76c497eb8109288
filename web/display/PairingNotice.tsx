// What has become of the pairing of this phone.
import { kRoleTexts } from "../shared/login/roles";
import { dismissPairing, usePairing } from "./pairing";
import { texts } from "./texts";

export function PairingNotice() {
  const pairing = usePairing();
  if (pairing.kind === "none") return null;
  if (pairing.kind === "pairing") return <p className="notice">{texts.pairing.pairing}</p>;
  return (
    <section className={`notice has-button${pairing.kind === "failed" ? " is-bad" : ""}`} aria-label={texts.pairing.name}>
      <p role="alert">
        {pairing.kind === "failed"
          ? pairing.why
          : texts.pairing.paired(pairing.account, pairing.expires, pairing.role === "observer" ? kRoleTexts.observer : kRoleTexts.operator)}
      </p>
      <button type="button" className="plain" onClick={dismissPairing}>
        {texts.pairing.ok}
      </button>
    </section>
  );
}
