// What has become of the pairing of this phone.
import { kRoleTexts } from "../shared/login/roles";
import { dismissPairing, usePairing } from "./pairing";

export function PairingNotice() {
  const pairing = usePairing();
  if (pairing.kind === "none") return null;
  if (pairing.kind === "pairing") return <p className="notice">Pairing this phone…</p>;
  return (
    <section className={`notice has-button${pairing.kind === "failed" ? " is-bad" : ""}`} aria-label="Pairing">
      <p role="alert">
        {pairing.kind === "failed"
          ? pairing.why
          : `Paired by ${pairing.account} until ${new Date(pairing.expires).toLocaleDateString("en-GB", { day: "numeric", month: "long", year: "numeric" })}: it ${pairing.role === "observer" ? kRoleTexts.observer : kRoleTexts.operator}.`}
      </p>
      <button type="button" className="plain" onClick={dismissPairing}>
        OK
      </button>
    </section>
  );
}
