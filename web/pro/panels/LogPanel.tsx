// The server's log, newest at the end, with what was forced in the watched run, and a filter.
import { useMemo, useState } from "react";
import type { LogEntry } from "../../generated/messages";
import { momentText } from "../../shared/past/moment";
import type { Forced } from "../../shared/run/forced";
import { inputEntry } from "../../shared/runs/callLog";
import { forcedLines, matchingLines, runLog, type LogLine } from "../../shared/runs/runLog";
import { useSession } from "../client";
import { useTimes } from "../timeline/times";
import { showInput } from "./showInput";
import { useEndInView } from "./useEndInView";
import { useForced } from "./useForced";

export function LogPanel() {
  const log = useSession((s) => s.log);
  const id = useSession((s) => s.watched);
  const forced = useForced();
  const [filter, setFilter] = useState("");
  return (
    <section className="log" aria-label="Log">
      <input type="search" placeholder="Filter" aria-label="Filter the log" value={filter} onChange={(event) => setFilter(event.target.value)} />
      {id === undefined || forced.length === 0 ? <Lines lines={matchingLines(log, filter)} /> : <WithForced id={id} log={log} forced={forced} filter={filter} />}
    </section>
  );
}

interface Props {
  readonly log: readonly LogEntry[];
  readonly id: string;
  readonly forced: readonly Forced[];
  readonly filter: string;
}

/** The server tells the times of so many macro steps at once: what was forced before them is not shown. */
const kMostTimes = 1000;

function WithForced({ log, id, forced: all, filter }: Props) {
  const to = all.at(-1)?.step ?? 1;
  const entries = useMemo(() => all.filter(({ step }) => step > to - kMostTimes).map(({ step, input }) => inputEntry(input, step)), [all, to]);
  const from = entries[0]?.step ?? 1;
  const { times: first } = useTimes(id, 1, 1);
  const { times: forced } = useTimes(id, from, to);
  const times = useMemo(() => first && forced && { ...forced, began: new Map([...first.began, ...forced.began]) }, [first, forced]);
  const lines = useMemo(() => matchingLines(runLog(log, forcedLines(log, id, entries, times)), filter), [log, id, entries, times, filter]);
  return <Lines lines={lines} />;
}

function Lines({ lines }: { readonly lines: readonly LogLine[] }) {
  const end = useEndInView<HTMLDivElement>(lines);
  return (
    <div className="log-lines" role="log" {...end}>
      {lines.map((line, i) => (
        <Line key={i} line={line} />
      ))}
      {lines.length === 0 && <p className="quiet">No lines.</p>}
    </div>
  );
}

function Line({ line: { time, source, text, forced } }: { readonly line: LogLine }) {
  return (
    <div className={forced === undefined ? "log-line" : "log-line is-forced"}>
      <time>{time === undefined ? "" : `${time.toFixed(3)} s`}</time>
      <b>{source}</b>
      <span>
        {text}
        {forced !== undefined && (
          <>
            {", in "}
            <button type="button" className="link" title="Show it among the calls and events" onClick={() => showInput(forced.step)}>
              step {momentText({ step: forced.step, micro: 0 })}
            </button>
          </>
        )}
      </span>
    </div>
  );
}
