// While the arm is moved by hand: its tool is another one than at first, or its service is gone.
import { useState } from "react";
import type { HostedService } from "../generated/messages";
import { toolOf, toolWarning } from "../shared/control/tool";
import { texts } from "./texts";

export function ToolNotice({ services }: { readonly services: readonly HostedService[] }) {
  const now = toolOf(services);
  const [first, setFirst] = useState(now);
  // The services may not be known at once.
  if (first === undefined && now !== undefined) setFirst(now);
  const warning = toolWarning(first, services);
  if (warning === undefined) return null;
  return (
    <p className="tool-notice is-bad" role="alert">
      {warning}{" "}
      {now !== undefined && (
        <button type="button" className="plain" onClick={() => setFirst(now)}>
          {texts.tool.read}
        </button>
      )}
    </p>
  );
}
