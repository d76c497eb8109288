// A selected barrier: the set of ports that have arrived, and those it waits for.
import type { Barrier } from "../../shared/model/model";
import { stateShown } from "../../shared/past/shown";
import { inboundPorts, type ModelTree } from "../../shared/model/modelTree";
import { useSession, view } from "../client";
import { RunComments } from "../comments/RunComments";
import { counted } from "../../shared/counted";

interface Props {
  readonly tree: ModelTree;
  readonly path: string;
  readonly barrier: Barrier;
}

export function BarrierProperties({ tree, path, barrier }: Props) {
  const run = useSession(stateShown);
  const active = run?.active.includes(path) === true;
  const arrived = run?.activated[path] ?? [];
  const inbound = inboundPorts(tree, path);
  return (
    <>
      <header className="prop-head">
        <small>Barrier · {path}</small>
        <h2>{barrier.name}</h2>
        <span className={`pill ${active ? "is-running" : ""}`}>{active ? "Active" : "Inactive"}</span>
      </header>
      <section aria-label="Waits for">
        <h3>
          {arrived.length} of {counted(inbound.length, "inbound port has", "inbound ports have")} arrived
        </h3>
        <ul className="arrivals">
          {inbound.map((port) => (
            <li key={port} className={arrived.includes(port) ? "arrived" : ""}>
              <button type="button" className="link" onClick={() => view.dispatch({ type: "jump", selection: { kind: "port", address: port } })}>
                {port}
              </button>
              <small>{arrived.includes(port) ? "arrived" : "waits"}</small>
            </li>
          ))}
        </ul>
        {inbound.length === 0 && <p className="quiet">No port leads here: it opens when its state is entered.</p>}
      </section>
      <section aria-label="Activates">
        <h3>Activates, all at once</h3>
        <ul className="arrivals">
          {barrier.to.map((name) => (
            <li key={name}>{name}</li>
          ))}
        </ul>
      </section>
      <RunComments id={barrier.id} />
    </>
  );
}
