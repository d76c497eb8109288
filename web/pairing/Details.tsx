// What whoever runs the server does once: how a phone reaches a server that listens on its own machine alone, and how it comes to trust it.
import type { Pairing } from "../shared/display/pairing";
import { texts } from "./texts";

const t = texts.details;

interface Props {
  readonly tunnel: Pairing["tunnel"] | undefined;
  readonly trust: string | undefined;
}

export function Details({ tunnel, trust }: Props) {
  if (tunnel === undefined && trust === undefined) return null;
  return (
    <details className="pairing-details">
      <summary>{t.name}</summary>
      {tunnel !== undefined && <Reach tunnel={tunnel} />}
      {trust !== undefined && (
        <p>
          {t.trust} <a href={trust}>{trust}</a>
        </p>
      )}
    </details>
  );
}

function Reach({ tunnel: { usb, ssh } }: { readonly tunnel: NonNullable<Pairing["tunnel"]> }) {
  return (
    <>
      <p>{t.local}</p>
      <dl>
        <dt>{t.network}</dt>
        <dd>
          <code>{t.serve}</code>
        </dd>
      </dl>
      <p>
        {t.account} <code>{t.addAccount}</code>
      </p>
      <p>{t.tunnel}</p>
      <dl>
        <dt>{t.usb}</dt>
        <dd>
          <code>{usb}</code>
        </dd>
        <dt>{t.ssh}</dt>
        <dd>
          <code>{ssh}</code>
        </dd>
      </dl>
    </>
  );
}
