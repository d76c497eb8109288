// A state in the thesis' notation (Fig. 3.2-3.4): rounded frame, name, text section, ports on the border.
import { Handle, Position, type NodeProps, type Node } from "@xyflow/react";
import type { CSSProperties } from "react";
import type { DrawnNode, DrawnPort } from "../../shared/drawing/drawing";
import { liveValue } from "../../shared/drawing/live";
import { nameRoom, portNameRoom } from "../../shared/drawing/measure";
import { waitingState } from "../../shared/model/afters";
import { clip, valueText, type Line } from "../../shared/model/describe";
import type { Dispatcher } from "../../shared/model/model";
import { errorsText } from "../../shared/run/errorsText";
import { useView, view } from "../client";
import { useErrorCount } from "../edit/errors";
import { Icon } from "../panels/Icon";
import { doubleClicked } from "./doubleClick";
import { useLive } from "./useLive";

export type StateFlowNode = Node<{ readonly drawn: DrawnNode }, "state">;

export function StateNode({ data: { drawn } }: NodeProps<StateFlowNode>) {
  const selected = useView((v) => (v.selection?.kind === "node" && v.selection.path === drawn.path) || v.also.has(drawn.path));
  const active = useLive((live) => live.active.has(drawn.path));
  const faulted = useLive((live) => live.faultAt === drawn.path);
  const errors = useErrorCount(drawn.path, drawn.composite && !drawn.open);
  const covered = drawn.side === "EAST" && !drawn.open && drawn.ports.length > 0;
  const classes = ["state", drawn.dispatcher !== undefined && "is-dispatcher", covered && "has-ports-east", active && "is-active", selected && "is-selected", drawn.open && "is-open", faulted && "is-faulted"];
  const select = () => view.dispatch({ type: "select", selection: { kind: "node", path: drawn.path } });
  return (
    <div
      className={classes.filter(Boolean).join(" ")}
      role="group"
      aria-label={`${drawn.dispatcher === undefined ? "State" : "Dispatcher"} ${drawn.path}`}
      data-path={drawn.path}
      data-active={active}
      data-error={errors > 0 ? errors : undefined}
      aria-description={errors > 0 ? errorsText(errors) : undefined}
      style={withRoom({ width: drawn.width, height: drawn.height }, nameRoom(drawn))}
      onClick={select}
      onDoubleClick={(event) => doubleClicked(event, { kind: "node", path: drawn.path }, drawn.composite ? drawn.path : undefined)}
    >
      <Handle type="target" position={Position.Left} isConnectable={false} />
      <Handle type="source" position={Position.Right} isConnectable={false} />
      <div className="state-head">
        <button type="button" className="state-name" aria-label={`Select ${drawn.path}`} title={titleOf(drawn)} onClick={select}>
          {drawn.dispatcher === undefined ? drawn.name : kSigns[drawn.dispatcher]}
        </button>
        {drawn.badge !== undefined && <span className={`state-badge${drawn.badge.startsWith("oracle") ? " is-oracle" : ""}`}>{drawn.badge}</span>}
        {drawn.composite && <Toggle drawn={drawn} />}
      </div>
      {drawn.lines.length > 0 && <TextSection drawn={drawn} />}
      {drawn.ports.map((port) => (
        <PortBox key={port.address} port={port} origin={drawn} />
      ))}
    </div>
  );
}

/** The signs of dispatchers: those of UML for histories. */
export const kSigns: Readonly<Record<Dispatcher, string>> = { history: "H", "deep history": "H*", choice: "?" };

const titleOf = ({ dispatcher, name }: DrawnNode): string => (dispatcher === undefined ? name : `${name} of the oracle: which state is entered first`);

function portTitle({ name, when, timed }: DrawnPort, { dispatcher }: DrawnNode): string {
  if (timed) return `${when}: this long after the activation of its state`;
  return dispatcher === undefined ? when : `${name}: ${when}`;
}

/** How much larger the name may be written, for the style sheet. */
const withRoom = (style: CSSProperties, room: number): CSSProperties & Record<"--room", number> => ({ ...style, "--room": room });

function Toggle({ drawn }: { readonly drawn: DrawnNode }) {
  return (
    <button
      type="button"
      className="state-toggle"
      aria-label={`${drawn.open ? "Collapse" : "Expand"} ${drawn.path}`}
      aria-expanded={drawn.open}
      onClick={(event) => {
        event.stopPropagation();
        view.dispatch({ type: "toggle", path: drawn.path });
      }}
      onDoubleClick={(event) => event.stopPropagation()}
    >
      {drawn.open ? "−" : "+"}
    </button>
  );
}

function TextSection({ drawn }: { readonly drawn: DrawnNode }) {
  return (
    <dl className="state-text">
      {drawn.lines.map((line, i) => (
        <div key={i}>
          <dt>{drawn.lines[i - 1]?.label === line.label ? "" : line.label}</dt>
          <LineText path={drawn.path} line={line} />
        </div>
      ))}
    </dl>
  );
}

function LineText({ path, line }: { readonly path: string; readonly line: Line }) {
  const value = useLive((live) => liveValue(live, path, line));
  return (
    <dd title={value === undefined ? line.text : `${line.text}\nnow ${valueText(value)}`}>
      {line.text}
      {value !== undefined && line.label !== "params" && <span className="live"> = {clip(valueText(value), 18)}</span>}
    </dd>
  );
}

function PortBox({ port, origin }: { readonly port: DrawnPort; readonly origin: DrawnNode }) {
  const selected = useView((v) => v.selection?.kind === "port" && v.selection.address === port.address);
  const fireCount = useLive((live) => (live.fired.has(port.address) ? live.fireCount : 0));
  const active = useLive((live) => live.ports.has(port.address));
  const waits = useLive((live) => port.timed && live.active.has(waitingState(port.address)));
  const faulted = useLive((live) => port.timed && live.faultAt === waitingState(port.address));
  const endsBadly = useLive((live) => live.badEnd === port.address);
  const fired = fireCount > 0 && !endsBadly;
  const errors = useErrorCount(port.address);
  const classes = ["port", active && "is-active", selected && "is-selected", fired && "is-fired", port.exits && "is-exit", waits && "is-waiting", faulted && "is-faulted", endsBadly && "ends-badly"];
  return (
    <button
      key={fireCount}
      type="button"
      className={classes.filter(Boolean).join(" ")}
      aria-label={`Port ${port.address}`}
      data-address={port.address}
      data-active={active}
      data-fired={fired}
      data-error={errors > 0 ? errors : undefined}
      aria-description={errors > 0 ? errorsText(errors) : undefined}
      title={portTitle(port, origin)}
      style={withRoom({ left: port.x - origin.x, top: port.y - origin.y, width: port.width, height: port.height }, portNameRoom(port))}
      onClick={(event) => {
        event.stopPropagation();
        view.dispatch({ type: "select", selection: { kind: "port", address: port.address } });
      }}
      onDoubleClick={(event) => {
        event.stopPropagation();
        doubleClicked(event, { kind: "port", address: port.address }, undefined);
      }}
    >
      {origin.dispatcher === undefined && (
        <span className="port-name">
          {port.timed && <Icon name="clock" />}
          {port.name}
        </span>
      )}
      {origin.dispatcher === undefined && port.condition !== "" && <code>{port.condition}</code>}
    </button>
  );
}
