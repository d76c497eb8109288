// How a phone becomes a display: the address as a link and as a QR code, and how it reaches the server.
import { lazy, Suspense, useEffect, useRef, useState } from "react";
import { isDisplayName, pairing } from "../../shared/display/pairing";
import { askPairing, usePairing } from "./pairing";

const QrCode = lazy(() => import("./QrCode").then(({ QrCode }) => ({ default: QrCode })));

export function PairPhone() {
  return usePairing() ? <Dialog /> : null;
}

/** As in the README; a task shows most things on all displays. */
const kDefaultName = "phone1";

const close = () => askPairing(false);

function Dialog() {
  const dialog = useRef<HTMLDialogElement>(null);
  const [name, setName] = useState(kDefaultName);
  useEffect(() => dialog.current?.showModal(), []);
  const isName = isDisplayName(name);
  const { address, trust, tunnel } = pairing(location, isName ? name : kDefaultName);
  return (
    <dialog ref={dialog} className="pairing" aria-label="Pair a phone" onClose={close} onClick={(event) => event.target === event.currentTarget && close()} onKeyDown={(event) => event.stopPropagation()}>
      <div className="pairing-body">
        <header>
          <h2>Pair a phone</h2>
          <button type="button" aria-label="Close" onClick={close}>
            ✕
          </button>
        </header>
        <p>The phone becomes a display: tasks show messages and questions on it, and a person answers there.</p>
        <label>
          Name of the display{" "}
          <input type="text" value={name} aria-invalid={!isName} aria-describedby={isName ? undefined : "pairing-name"} spellCheck={false} autoComplete="off" onChange={(event) => setName(event.target.value)} />
        </label>
        {!isName && (
          <p id="pairing-name" className="bad" role="alert">
            A name has 1 to 32 of A-Z, a-z, 0-9, _ and -, and is not all.
          </p>
        )}
        {tunnel !== undefined && (
          <>
            <h3>1. Lead the phone to the server</h3>
            <p>This page comes from the machine of the server itself, and no phone reaches it at that address. Another device needs the network:</p>
            <dl>
              <dt>In a network</dt>
              <dd>
                <code>race serve --lan</code>
              </dd>
            </dl>
            <p>
              It needs an account, made by <code>race account add NAME --role admin --data DIR</code>, and prints its addresses. Open this page at one of them, and the code below leads the phone there. Without a network, a tunnel that ends on this
              machine leads to it:
            </p>
            <dl>
              <dt>Android, by USB</dt>
              <dd>
                <code>{tunnel.usb}</code>
              </dd>
              <dt>By SSH, on the phone</dt>
              <dd>
                <code>{tunnel.ssh}</code>
              </dd>
            </dl>
            <h3>2. Open the display there</h3>
          </>
        )}
        {trust !== undefined && (
          <p>
            The phone warns of this server until it trusts it, which it learns once at <a href={trust}>{trust}</a>.
          </p>
        )}
        {isName && (
          <>
            <Suspense fallback={<p className="quiet">Drawing the code…</p>}>
              <QrCode text={address} />
            </Suspense>
            <a href={address} target="_blank" rel="noreferrer">
              {address}
            </a>
          </>
        )}
      </div>
    </dialog>
  );
}
