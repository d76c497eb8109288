// A selected port, and the answer to "why did it fire, or why not?".
import { kOfPort } from "../../shared/debugger/places";
import { waitingState } from "../../shared/model/afters";
import { portText, valueText } from "../../shared/model/describe";
import { leadsText } from "../../shared/model/leadsText";
import type { Port } from "../../shared/model/model";
import { nameOf, splitAddress, type ModelTree } from "../../shared/model/modelTree";
import { firedShown, stateShown } from "../../shared/past/shown";
import { useSession, view } from "../client";
import { BreakpointChoices } from "../debugger/BreakpointChoices";
import { AskWhy } from "./AskWhy";

export function PortProperties({ tree, address, port }: { readonly tree: ModelTree | undefined; readonly address: string; readonly port: Port }) {
  const run = useSession(stateShown);
  const fired = useSession((s) => firedShown(s).ports.includes(address));
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
        <h3>{port.after === undefined ? "Condition" : "Time-out"}</h3>
        <pre className="code code-wraps">
          <code>{portText(port)}</code>
        </pre>
        {port.after !== undefined && <Waiting address={address} />}
        <p className="quiet">{leadsText(port, path, tree)}</p>
      </section>
      <BreakpointChoices kinds={kOfPort} />
      <AskWhy key={address} subject={{ port: address }} />
    </>
  );
}

/** What a port with a time-out waits for, and what it is in derivations and explanations. */
function Waiting({ address }: { readonly address: string }) {
  const path = waitingState(address);
  const seconds = useSession((s) => (stateShown(s)?.active.includes(path) === true ? stateShown(s)?.parameters.get(path)?.["seconds"] : undefined));
  return (
    <p className="quiet">
      Counted from the activation of its state{seconds === undefined ? "" : `, this time ${valueText(seconds)} s`}. In the derivation, the state <code>{nameOf(path)}</code> waits for it.
    </p>
  );
}
