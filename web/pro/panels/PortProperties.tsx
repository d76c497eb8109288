// A selected port, and the answer to "why did it fire, or why not?".
import { useEffect, useState } from "react";
import type { Why } from "../../shared/messages/why";
import type { Port } from "../../shared/model/model";
import { splitAddress } from "../../shared/model/modelTree";
import { api, useCore, useSession, view } from "../client";
import { WhyView } from "./WhyView";

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
        <pre className="code">
          <code>{port.when}</code>
        </pre>
        <p className="quiet">{port.to === undefined ? "Leads nowhere: it may end its parent." : `Leads to ${port.to}.`}</p>
      </section>
      <AskWhy address={address} />
    </>
  );
}

/** The server's explanation for the present state; asked again after every step. */
function AskWhy({ address }: { readonly address: string }) {
  const core = useCore();
  const run = useSession((s) => s.run);
  const [why, setWhy] = useState<Why>();
  const [failed, setFailed] = useState<string>();
  const id = core?.id;
  useEffect(() => {
    if (id === undefined) return;
    let current = true;
    api.why(id, address).then(
      (answer) => {
        if (!current) return;
        setWhy(answer);
        setFailed(undefined);
      },
      (error: unknown) => current && setFailed(error instanceof Error ? error.message : String(error)),
    );
    return () => {
      current = false;
    };
  }, [id, address, run]);
  if (failed !== undefined) return <p className="quiet">No explanation: {failed}</p>;
  return why === undefined ? null : <WhyView why={why} />;
}
