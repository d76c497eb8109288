// The server is not there: nobody overlooks it.
import { useEffect, useState } from "react";

export function LostServer() {
  const [since] = useState(Date.now);
  const [now, setNow] = useState(since);
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now()), 1000);
    return () => clearInterval(timer);
  }, []);
  return (
    <section className="lost-server" role="alert" aria-label="No connection">
      <strong>NO CONNECTION</strong>
      <p>What you moved by hand has stopped. A run may go on: this page does not see it.</p>
      <p>
        Trying again… <span aria-hidden="true">{Math.round((now - since) / 1000)} s</span>
      </p>
    </section>
  );
}
