// Right panel: everything about the selected state, barrier or port, with its live values.
import { barrierAt, portAt, stateAt, type ModelTree } from "../../shared/model/modelTree";
import { useView } from "../client";
import { BarrierProperties } from "./BarrierProperties";
import { PortProperties } from "./PortProperties";
import { RunProperties } from "./RunProperties";
import { StateProperties } from "./StateProperties";

export function PropertiesPanel({ tree }: { readonly tree: ModelTree | undefined }) {
  const selection = useView((v) => v.selection);
  return (
    <aside className="side side-right" aria-label="Properties">
      {tree === undefined || selection === undefined ? (
        <RunProperties tree={tree} />
      ) : selection.kind === "port" ? (
        <PortSection tree={tree} address={selection.address} />
      ) : (
        <NodeSection tree={tree} path={selection.path} />
      )}
    </aside>
  );
}

function PortSection({ tree, address }: { readonly tree: ModelTree; readonly address: string }) {
  const port = portAt(tree, address);
  return port === undefined ? <RunProperties tree={tree} /> : <PortProperties key={address} tree={tree} address={address} port={port} />;
}

function NodeSection({ tree, path }: { readonly tree: ModelTree; readonly path: string }) {
  const state = stateAt(tree, path);
  if (state !== undefined) return <StateProperties key={path} path={path} state={state} />;
  const barrier = barrierAt(tree, path);
  return barrier === undefined ? <RunProperties tree={tree} /> : <BarrierProperties key={path} tree={tree} path={path} barrier={barrier} />;
}
