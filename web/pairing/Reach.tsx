// How a phone reaches a server that listens on its own machine alone.
import type { Pairing } from "../shared/display/pairing";

export function Reach({ tunnel: { usb, ssh } }: { readonly tunnel: NonNullable<Pairing["tunnel"]> }) {
  return (
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
        It needs an account, made by <code>race account add NAME --role admin --data DIR</code>, and prints its addresses; then the code here leads the phone there. Without a network, a tunnel that ends on this machine leads to it:
      </p>
      <dl>
        <dt>Android, by USB</dt>
        <dd>
          <code>{usb}</code>
        </dd>
        <dt>By SSH, on the phone</dt>
        <dd>
          <code>{ssh}</code>
        </dd>
      </dl>
      <h3>2. Open the display there</h3>
    </>
  );
}
