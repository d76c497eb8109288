// A chain of ports that led to an end: each a way to the port, and to the micro step in which it fired.
import { microStepText } from "../../shared/derivation/proof";
import type { Cause } from "../../shared/run/causes";
import { view } from "../client";

export function CauseList({ chain }: { readonly chain: readonly Cause[] }) {
  if (chain.length === 0) return null;
  return (
    <ol className="causes" aria-label="Causes">
      {chain.map((cause) => (
        <li key={cause.address}>
          <CauseRow cause={cause} />
        </li>
      ))}
    </ol>
  );
}

function CauseRow({ cause: { address, condition, firing } }: { readonly cause: Cause }) {
  return (
    <>
      <button type="button" className="link" onClick={() => view.dispatch({ type: "jump", selection: { kind: "port", address } })}>
        {address}
      </button>
      <code>{condition}</code>
      <button type="button" className="link" onClick={() => view.dispatch({ type: "step", step: firing.step, inference: { micro: firing.micro, of: { port: address } } })}>
        {microStepText(firing)}
      </button>
    </>
  );
}
