// What has become of the code on this page, and the button for another one.
import type { CodeState } from "./code";
import { texts } from "./texts";

const t = texts.code;

interface Props {
  readonly code: CodeState;
  readonly onRenew: () => void;
}

export function CodeNotice({ code, onRenew }: Props) {
  if (code.kind === "none") return null;
  if (code.kind === "asked") return <p className="quiet">{t.asking}</p>;
  const renew = (
    <button type="button" className="pairing-renew" onClick={onRenew}>
      {t.renew}
    </button>
  );
  // It learns nothing of what the phone says.
  if (code.kind === "there")
    return (
      <p className="quiet">
        {t.used} {renew}
      </p>
    );
  return (
    <p role="alert">
      {code.kind === "over" ? t.over : code.why} {renew}
    </p>
  );
}
