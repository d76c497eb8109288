// What the watched run has called and what has come to it: newest last, each entry a way to its micro step.
import { useMemo, useState } from "react";
import { folded, kEntryKinds, loggedStep, matchingEntries, servicesOf, type EntryKind, type RunEntry } from "../../shared/runs/callLog";
import { momentText } from "../../shared/past/moment";
import { useSession } from "../client";
import { useEndInView } from "../panels/useEndInView";
import { visit } from "../past/past";
import { useSteps, useStepsToCome } from "../timeline/loading";

/** So many entries are shown, the last ones. */
const kMostEntries = 1000;

const kNames: Readonly<Record<EntryKind, string>> = { call: "Calls", response: "Responses", event: "Events", force: "Forced", run: "Of the run" };

export function CallLog() {
  const loaded = useSteps(loggedStep);
  const toCome = useStepsToCome(loaded);
  const [kind, setKind] = useState<EntryKind>();
  const [service, setService] = useState<string>();
  const [text, setText] = useState("");
  const entries = useMemo(() => folded(loaded?.steps.flatMap((step) => step.entries) ?? []), [loaded]);
  const services = useMemo(() => servicesOf(entries), [entries]);
  const shown = useMemo(() => matchingEntries(entries, { kind, service, text }).slice(-kMostEntries), [entries, kind, service, text]);
  return (
    <section className="call-log" aria-label="Calls and events">
      <div className="call-log-filter" role="search" aria-label="Filter calls and events">
        <select aria-label="Kind" value={kind ?? ""} onChange={(event) => setKind(kEntryKinds.find((each) => each === event.target.value))}>
          <option value="">All kinds</option>
          {kEntryKinds.map((each) => (
            <option key={each} value={each}>
              {kNames[each]}
            </option>
          ))}
        </select>
        <select aria-label="Service" value={service ?? ""} onChange={(event) => setService(event.target.value === "" ? undefined : event.target.value)}>
          <option value="">All services</option>
          {services.map((each) => (
            <option key={each}>{each}</option>
          ))}
        </select>
        <input type="search" placeholder="Filter" aria-label="Text of calls and events" value={text} onChange={(event) => setText(event.target.value)} />
        <span role="status">{loaded?.failed ?? (entries.length === 0 ? "" : `${shown.length} of ${entries.length}, newest last`)}</span>
      </div>
      {shown.length > 0 ? <Entries entries={shown} /> : <p className="quiet pad">{entries.length > 0 ? "No entry fits this filter." : toCome ? "Loading the steps of the run…" : "What the run calls, and the responses and events that come to it, appear here with its first step."}</p>}
    </section>
  );
}

function Entries({ entries }: { readonly entries: readonly RunEntry[] }) {
  const end = useEndInView<HTMLOListElement>(entries);
  return (
    <ol aria-label="Entries" {...end}>
      {entries.map((entry, i) => (
        <Entry key={`${momentText(entry)}/${i}`} entry={entry} />
      ))}
    </ol>
  );
}

function Entry({ entry }: { readonly entry: RunEntry }) {
  const isShown = useSession((s) => s.past?.past.step === entry.step && s.past.past.micro === entry.micro);
  const show = () => {
    visit({ step: entry.step, micro: entry.micro });
  };
  return (
    <li className={`is-${entry.kind}`}>
      <button type="button" aria-current={isShown ? "step" : undefined} title="Show the run as it was then" onClick={show}>
        <time>{momentText(entry)}</time>
        <b>{entry.kind === "run" ? "" : entry.kind}</b>
        <code>{entry.kind === "call" ? entry.text : entry.text.replace(/^(event|response|force) /, "")}</code>
        {entry.count > 1 && <small>× {entry.count}</small>}
      </button>
    </li>
  );
}
