// The server does not answer: over the whole width, so that nobody takes the page for alive.
import { lostText } from "../../shared/run/lostText";
import { useCore, useSession } from "../client";

export function LostServer() {
  const lost = useSession((s) => s.connection === "lost");
  const ended = useSession((s) => s.ended);
  const core = useCore();
  if (!lost) return null;
  const { title, holds } = lostText(core, ended);
  return (
    <div className="lost-server" role="alert" aria-label="Server lost">
      <strong>{title}</strong>
      <span>{holds}</span>
    </div>
  );
}
