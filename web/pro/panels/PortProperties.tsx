// A selected port, and the answer to "why did it fire, or why not?".
import type { Port } from "../../shared/model/model";
import { splitAddress } from "../../shared/model/modelTree";
import { useSession, view } from "../client";
import { AskWhy } from "./AskWhy";

export function PortProperties({ address, port }: { readonly address: string; readonly port: Port }) {
  const run = useSession((s) => s.run);
  const fired = useSession((s) => s.fired.ports.includes(address));
  const active = run?.ports.includes(address) === true;
  const path = splitAddress(address)?.path ?? "";
  return (
    <>
      <header className="prop-head">
        <small>
          Port of{" "}
          <button type="button" className="link" onClick={() => view.dispatch({ type: "select", selection: { kind: "node", path } })}>
            {path}
          </button>
        </small>
        <h2>{port.name}</h2>
        <span className={`pill ${active || fired ? "is-running" : ""}`}>{fired ? "Just fired" : active ? "Active" : "Inactive"}</span>
      </header>
      <section>
        <h3>Condition</h3>
        <pre className="code code-wraps">
          <code>{port.when}</code>
        </pre>
        <p className="quiet">{port.to === undefined ? "Leads nowhere: it may end its parent." : `Leads to ${port.to}.`}</p>
      </section>
      <AskWhy key={address} address={address} />
    </>
  );
}
