// While the arm is moved by hand: its tool is another one than at first, or its service is gone.
import { useState } from "react";
import type { HostedService } from "../generated/messages";
import { toolChange, toolOf } from "../shared/control/tool";
import { texts } from "./texts";

export function ToolNotice({ services }: { readonly services: readonly HostedService[] }) {
  const now = toolOf(services);
  const [first, setFirst] = useState(now);
  // The services may not be known at once.
  if (first === undefined && now !== undefined) setFirst(now);
  const change = toolChange(first, services);
  if (change === undefined) return null;
  return (
    <p className="tool-notice is-bad" role="alert">
      {change.kind === "gone" ? texts.tool.gone(change.before.key) : texts.tool.another(change.now.name, change.before.name)}{" "}
      {now !== undefined && (
        <button type="button" className="plain" onClick={() => setFirst(now)}>
          {texts.tool.read}
        </button>
      )}
    </p>
  );
}
