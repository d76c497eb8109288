// The server does not answer: over the whole width, so that nobody takes the page for alive.
import { lostText } from "../../shared/run/lostText";
import { useCore, useSession } from "../client";

export function LostServer() {
  const lost = useSession((s) => s.connection === "lost");
  const core = useCore();
  if (!lost) return null;
  const { title, holds } = lostText(core);
  return (
    <div className="lost-server" role="alert" aria-label="Server lost">
      <strong>{title}</strong>
      <span>{holds}</span>
    </div>
  );
}
