// The server's log, newest at the end, with a filter.
import { useEffect, useMemo, useRef, useState } from "react";
import { useSession } from "../client";

export function LogPanel() {
  const log = useSession((s) => s.log);
  const [filter, setFilter] = useState("");
  const end = useRef<HTMLDivElement>(null);
  const shown = useMemo(() => {
    const wanted = filter.trim().toLowerCase();
    return wanted === "" ? log : log.filter((entry) => `${entry.source} ${entry.text}`.toLowerCase().includes(wanted));
  }, [log, filter]);
  useEffect(() => {
    end.current?.scrollIntoView({ block: "nearest" });
  }, [shown]);
  return (
    <section className="log" aria-label="Log">
      <input type="search" placeholder="Filter" aria-label="Filter the log" value={filter} onChange={(event) => setFilter(event.target.value)} />
      <div className="log-lines" role="log">
        {shown.map((entry, i) => (
          <div key={i} className="log-line">
            <time>{entry.time.toFixed(3)} s</time>
            <b>{entry.source}</b>
            <span>{entry.text}</span>
          </div>
        ))}
        {shown.length === 0 && <p className="quiet">No lines.</p>}
        <div ref={end} />
      </div>
    </section>
  );
}
