// The address of the display page of a phone, as a link and as a QR code.
import { lazy, Suspense, useEffect, useState } from "react";
import { texts } from "./texts";

const t = texts.code;

const QrCode = lazy(() => import("./QrCode").then(({ QrCode }) => ({ default: QrCode })));

interface Props {
  readonly address: string;
  /** When its secret is good no more [ms since 1970]; nothing: it has none. */
  readonly until: number | undefined;
}

export function PairCode({ address, until }: Props) {
  return (
    <>
      <Suspense fallback={<p className="quiet">{t.drawing}</p>}>
        <QrCode text={address} />
      </Suspense>
      {until === undefined ? (
        <a href={address} target="_blank" rel="noreferrer">
          {address}
        </a>
      ) : (
        <p>
          {t.good} <Left until={until} /> {t.more}
        </p>
      )}
    </>
  );
}

function Left({ until }: { readonly until: number }) {
  const [now, setNow] = useState(Date.now);
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now()), 500);
    return () => clearInterval(timer);
  }, []);
  return <b>{t.seconds(Math.max(0, Math.ceil((until - now) / 1000)))}</b>;
}
