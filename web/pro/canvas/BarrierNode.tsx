// A barrier as a bar (Fig. 3.5), with what has arrived and what it still waits for.
import { Handle, Position, type Node, type NodeProps } from "@xyflow/react";
import type { DrawnNode } from "../../shared/drawing/drawing";
import { errorsText } from "../../shared/run/errorsText";
import { useView, view } from "../client";
import { useErrorCount } from "../edit/errors";
import { useLive } from "./useLive";
import { counted } from "../../shared/counted";

export type BarrierFlowNode = Node<{ readonly drawn: DrawnNode; readonly inbound: readonly string[] }, "barrier">;

export function BarrierNode({ data: { drawn, inbound } }: NodeProps<BarrierFlowNode>) {
  const selected = useView((v) => (v.selection?.kind === "node" && v.selection.path === drawn.path) || v.also.has(drawn.path));
  const active = useLive((live) => live.active.has(drawn.path));
  const arrived = useLive((live) => live.activated[drawn.path]) ?? [];
  const errors = useErrorCount(drawn.path);
  const missing = inbound.filter((port) => !arrived.includes(port));
  const waiting = arrived.length > 0 && missing.length > 0;
  const text = waiting ? `waits for ${missing.join(", ")}` : counted(inbound.length, "inbound port");
  return (
    <div style={{ width: drawn.width, height: drawn.height }}>
      <Handle type="target" position={Position.Left} isConnectable={false} />
      <Handle type="source" position={Position.Right} isConnectable={false} />
      <button
        type="button"
        className={["barrier", active && "is-active", selected && "is-selected", waiting && "is-waiting"].filter(Boolean).join(" ")}
        aria-label={`Barrier ${drawn.path}, ${text}`}
        data-path={drawn.path}
        data-active={active}
        data-error={errors > 0 ? errors : undefined}
        aria-description={errors > 0 ? errorsText(errors) : undefined}
        onClick={() => view.dispatch({ type: "select", selection: { kind: "node", path: drawn.path } })}
      />
      {waiting && (
        <span className="barrier-note">
          {arrived.length}/{inbound.length}
        </span>
      )}
    </div>
  );
}
