// The elements of the nodes in use, over the painted canvas: they are not seen, but read, focused and pressed as those of a small drawing.
import type { DrawnNode, DrawnPort } from "../../../shared/drawing/drawing";
import type { Scene } from "../../../shared/drawing/scene";
import { errorsText } from "../../../shared/run/errorsText";
import { useView, view } from "../../client";
import { useErrorCount } from "../../edit/errors";
import { CanvasLayer } from "../CanvasLayer";
import { useLiveSlowly } from "../useLive";
import { toggleBox } from "./paintNode";
import { counted } from "../../../shared/counted";

interface Props {
  readonly scene: Scene;
  readonly paths: readonly string[];
  readonly zoom: number;
}

export function InUse({ scene, paths, zoom }: Props) {
  return (
    <CanvasLayer className="in-use">
      {paths.map((path) => {
        const node = scene.node(path)?.node;
        if (node === undefined) return null;
        return node.kind === "barrier" ? <BarrierInUse key={path} node={node} inbound={scene.inbound(path)} /> : <StateInUse key={path} node={node} zoom={zoom} />;
      })}
    </CanvasLayer>
  );
}

const select = (path: string) => view.dispatch({ type: "select", selection: { kind: "node", path } });

const kinds = { state: "State", dispatcher: "Dispatcher" };

function StateInUse({ node, zoom }: { readonly node: DrawnNode; readonly zoom: number }) {
  const { path, x, y, width, height } = node;
  const active = useLiveSlowly((live) => live.active.has(path));
  const selected = useView((v) => v.selection?.kind === "node" && v.selection.path === path);
  const errors = useErrorCount(path, node.composite && !node.open);
  const toggle = toggleBox(node, zoom);
  const toggleStyle = { left: toggle.x - x, top: toggle.y - y, width: toggle.width, height: toggle.height };
  return (
    <div role="group" aria-label={`${node.dispatcher === undefined ? kinds.state : kinds.dispatcher} ${path}`} className={selected ? "is-selected" : ""} data-path={path} data-active={active} aria-description={errors > 0 ? errorsText(errors) : undefined} style={{ left: x, top: y, width, height }}>
      <button type="button" className="in-use-name state-name" aria-label={`Select ${path}`} title={node.name} onClick={() => select(path)} />
      {node.composite && <button type="button" aria-label={`${node.open ? "Collapse" : "Expand"} ${path}`} aria-expanded={node.open} style={toggleStyle} onClick={() => view.dispatch({ type: "toggle", path })} />}
      {node.ports.map((port) => (
        <PortInUse key={port.address} port={port} of={node} />
      ))}
    </div>
  );
}

function PortInUse({ port, of }: { readonly port: DrawnPort; readonly of: DrawnNode }) {
  const { address } = port;
  const active = useLiveSlowly((live) => live.ports.has(address));
  return (
    <button
      type="button"
      aria-label={`Port ${address}`}
      data-address={address}
      data-active={active}
      title={port.when}
      style={{ left: port.x - of.x, top: port.y - of.y, width: port.width, height: port.height }}
      onClick={() => view.dispatch({ type: "select", selection: { kind: "port", address } })}
    />
  );
}

function BarrierInUse({ node: { path, x, y, width, height }, inbound }: { readonly node: DrawnNode; readonly inbound: readonly string[] }) {
  const active = useLiveSlowly((live) => live.active.has(path));
  const arrived = useLiveSlowly((live) => live.activated[path]) ?? [];
  const missing = inbound.filter((port) => !arrived.includes(port));
  const text = arrived.length > 0 && missing.length > 0 ? `waits for ${missing.join(", ")}` : counted(inbound.length, "inbound port");
  return <button type="button" aria-label={`Barrier ${path}, ${text}`} data-path={path} data-active={active} style={{ left: x, top: y, width, height }} onClick={() => select(path)} />;
}
